//! A page works whatever the content of its scene, and sends no requests.

use cspace::Part;
use cspace::part::PartFeature;
use cspace_api::scene::{Scene, SceneRecord};
use cspace_cli::view::{Page, PageError};
use cspace_model::{Mechanism, PartEntry};
use serde_json::{Value, json};

const TEMPLATE: &str = "<head><!--style--></head><body><!--scene-->|<!--script--></body>";

/// Content of the scene's element as a browser takes it: all up to the first text that looks like its end.
fn scene_in(html: &str) -> Value {
    let (_, rest) = html
        .split_once(r#"<script type="application/json" id="scene">"#)
        .unwrap();
    let end = rest.to_ascii_lowercase().find("</script").unwrap();
    serde_json::from_str(&rest[..end]).unwrap()
}

#[test]
fn no_name_breaks_out_of_the_page() {
    let page = Page::new(TEMPLATE, "b{}", "0").unwrap();
    let plain = page
        .file(&Scene::of(&Mechanism::new("plain"), Vec::new(), Vec::new()))
        .unwrap();
    let names = [
        "</script><script>alert(1)</script>",
        "</SCRIPT ><img src=x onerror=alert(1)>",
        "<!--<script>",
        "-->",
        "<!--script--><!--style--><!--scene-->",
        "\"};alert(1);//",
        "\\\u{2028}\u{2029}\u{0}\u{7f}\"'&<>&lt;",
        "$& $1 $`",
        "]]>",
    ];
    for name in names {
        let mut model = Mechanism::new(name);
        model.unit = Some(name.to_owned());
        let part = Part::circle(name, (0.0, 0.0), 1.0).unwrap();
        let edge = PartFeature::Edge {
            loop_index: 0,
            index: 0,
        };
        model.parts.push(PartEntry::planar(
            part.with_feature_name(edge, name).unwrap(),
        ));
        let record = SceneRecord {
            name: name.to_owned(),
            record: json!({ name: name }),
        };
        let html = page
            .file(&Scene::of(&model, Vec::new(), vec![record]))
            .unwrap();
        let scene = scene_in(&html);
        assert_eq!(scene["name"], name);
        assert_eq!(scene["unit"], name);
        assert_eq!(scene["parts"][0]["name"], name);
        assert_eq!(
            scene["parts"][0]["feature_names"]["convex arc 0 of loop 0"],
            name
        );
        assert_eq!(scene["records"][0]["record"][name], name);
        // There are no more tags and comments in it than in the page of a plain name.
        assert_eq!(
            html.matches('<').count(),
            plain.matches('<').count(),
            "{html}"
        );
    }
}

#[test]
fn the_file_asks_nobody() {
    // The hash of this script is that in the text of the standard (Content Security Policy Level 3).
    let script = "alert('Hello, world.');";
    let page = Page::new(TEMPLATE, "b{}", script).unwrap();
    let html = page
        .file(&Scene::of(&Mechanism::new("plain"), Vec::new(), Vec::new()))
        .unwrap();
    let (before, rest) = html
        .split_once(r#"<meta http-equiv="Content-Security-Policy" content=""#)
        .unwrap();
    assert_eq!(before, "<head>");
    let policy = rest.split('"').next().unwrap();
    assert!(policy.contains("default-src 'none'"));
    assert!(
        policy.contains("script-src 'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='"),
        "{policy}"
    );
    assert!(
        !policy.contains("connect-src") && !policy.contains("http"),
        "{policy}"
    );
    assert!(
        html.ends_with("|<script>alert('Hello, world.');</script></body>"),
        "{html}"
    );
}

#[test]
fn templates_without_places_are_refused() {
    for (template, place) in [
        ("", "<!--style-->"),
        ("<!--scene--><!--style--><!--script-->", "<!--scene-->"),
        ("<!--style--><!--scene-->", "<!--script-->"),
        (
            "<!--style--><!--scene--><!--script--><!--script-->",
            "<!--script-->",
        ),
    ] {
        let error = Page::new(template, "", "").unwrap_err();
        assert_eq!(error, PageError::Template { place });
    }
    for (style, script) in [("</STYLE>", ""), ("", "'</script>'"), ("", "<!--")] {
        let error = Page::new(TEMPLATE, style, script).unwrap_err();
        assert!(matches!(error, PageError::Ends { .. }), "{error}");
    }
}

/// The page is bundled, or the error says how to get it.
#[test]
fn the_page_is_bundled_or_says_why_not() {
    match Page::bundled() {
        Ok(page) => {
            let html = page
                .file(&Scene::of(&Mechanism::new("plain"), Vec::new(), Vec::new()))
                .unwrap();
            assert_eq!(scene_in(&html)["name"], "plain");
            assert!(html.ends_with("</html>\n"));
            for fetched in ["src=\"", "href=\"http", "@import", "url(http"] {
                let head = html.split("<script").next().unwrap();
                assert!(!head.contains(fetched), "{fetched}");
            }
        }
        Err(error) => {
            assert!(matches!(error, PageError::NotBundled { .. }), "{error}");
            assert!(
                error
                    .to_string()
                    .starts_with("this program was built without its page: ")
            );
            assert!(error.help().contains("build"), "{}", error.help());
        }
    }
}
