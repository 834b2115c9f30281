//! Access control of the server.

use crate::view::server::client::Client;

/// Checks that a path without the right token reveals nothing.
#[track_caller]
fn tells_nothing(client: &Client, path: &str) {
    let answer = client.ask("GET", path, "", "");
    answer.fails(404, &["nothing here"]);
    assert!(!answer.body.contains("coin"), "{path}");
}

#[test]
fn without_the_token_nothing_is_told() {
    let client = Client::new();
    assert_eq!(client.get("").status, 200);
    let token = client.root.trim_matches('/');
    assert!(token.len() == 32 && token.bytes().all(|b| b.is_ascii_hexdigit()));
    let mut other = token.as_bytes().to_vec();
    other[31] = if other[31] == b'0' { b'1' } else { b'0' };
    let other = String::from_utf8(other).unwrap();
    for path in [
        "/",
        "//",
        "/pair/0",
        "/edit",
        "/model",
        &format!("/{other}/"),
        &format!("/{other}/pair/0"),
    ] {
        tells_nothing(&client, path);
    }
    for path in [
        format!("/{}/", &token[..31]),
        format!("/{token}0/"),
        format!("/{token}"),
        format!("/x/{token}/"),
    ] {
        tells_nothing(&client, &path);
    }
    // Another run has another one.
    assert_ne!(Client::new().root, client.root);
}

/// Sends the request with these lines in its head.
fn with_head(client: &Client, head: &str) -> u16 {
    let request = format!(
        "GET {} HTTP/1.1\r\n{head}Connection: close\r\n\r\n",
        client.root
    );
    let answer = client.send(request.as_bytes());
    assert_eq!(answer.status == 200, answer.body.contains("coin"), "{head}");
    answer.status
}

#[test]
fn only_requests_to_this_machine_are_answered() {
    let client = Client::new();
    let port = client.port;
    for host in [
        format!("127.0.0.1:{port}"),
        format!("localhost:{port}"),
        format!("LOCALHOST:{port}"),
    ] {
        assert_eq!(
            with_head(&client, &format!("Host: {host}\r\n")),
            200,
            "{host}"
        );
    }
    let hosts = [
        "127.0.0.1".to_owned(),
        "localhost".to_owned(),
        "evil.example".to_owned(),
        format!("evil.example:{port}"),
        format!("127.0.0.1:{}", port ^ 1),
        format!("127.0.0.1.evil.example:{port}"),
        format!("0.0.0.0:{port}"),
        String::new(),
    ];
    for host in hosts {
        assert_eq!(
            with_head(&client, &format!("Host: {host}\r\n")),
            403,
            "{host}"
        );
    }
    // None at all, which the old version of the protocol allows.
    let request = format!("GET {} HTTP/1.0\r\n\r\n", client.root);
    assert_eq!(client.send(request.as_bytes()).status, 403);
    let two = format!("Host: localhost:{port}\r\nHost: evil.example\r\n");
    assert_ne!(with_head(&client, &two), 200);
}

#[test]
fn only_pages_of_this_server_are_answered() {
    let client = Client::new();
    let port = client.port;
    let from = |origin: &str| {
        with_head(
            &client,
            &format!("Host: 127.0.0.1:{port}\r\nOrigin: {origin}\r\n"),
        )
    };
    assert_eq!(from(&format!("http://127.0.0.1:{port}")), 200);
    assert_eq!(from(&format!("http://localhost:{port}")), 200);
    for origin in [
        "null".to_owned(),
        String::new(),
        "http://evil.example".to_owned(),
        format!("https://127.0.0.1:{port}"),
        "http://127.0.0.1".to_owned(),
        format!("http://127.0.0.1:{}", port ^ 1),
        format!("http://127.0.0.1:{port}.evil.example"),
    ] {
        assert_eq!(from(&origin), 403, "{origin}");
    }
}

/// Refusals have the same headers as answers.
#[test]
fn every_answer_says_how_it_may_be_used() {
    let client = Client::new();
    let refused = client.ask("GET", &client.root, "Origin: http://evil.example\r\n", "");
    let answers = [
        client.get(""),
        client.get("pair/0"),
        client.get("nowhere"),
        client.post("pair/0", &1.into()),
        refused,
    ];
    assert_eq!(
        answers.each_ref().map(|a| a.status),
        [200, 200, 404, 405, 403]
    );
    for answer in &answers {
        assert_eq!(answer.header("cache-control"), Some("no-store"));
        assert_eq!(answer.header("x-content-type-options"), Some("nosniff"));
        assert_eq!(answer.header("referrer-policy"), Some("no-referrer"));
        let policy = answer.header("content-security-policy").unwrap();
        assert!(policy.contains("default-src 'none'"), "{policy}");
        assert!(policy.contains("frame-ancestors 'none'"), "{policy}");
        assert!(answer.header("access-control-allow-origin").is_none());
    }
}
