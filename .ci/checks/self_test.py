"""Little trees of files, and what the checks find in them."""

import tempfile
from collections.abc import Callable
from pathlib import Path

from .documents import documents_name_files_that_exist
from .rust_rules import (
    MOST_CONSTANTS,
    constants_are_explained_and_few,
    documentation_names_its_subject,
    double_double_is_named_by_formulas_only,
    rust_imports_go_one_way,
)
from .scripts import python_imports_go_one_way, typescript_imports_go_one_way

A = "crates/a/src/"
KERNEL = "crates/cspace/src/"
UI = "crates/cspace-cli/page/src/ui/"
PACKAGE = "crates/cspace-python/python/cspace/"

CIRCLE = {
    A + "lib.rs": "mod a;",
    A + "a/mod.rs": "mod part;\nmod pair;\npub use part::{Part as Shape};",
    A + "a/part.rs": "use super::pair::Pair;\npub struct Part(Pair);",
    A + "a/pair.rs": "/* a */\nfn f() { let _ = crate::a::Shape; }\npub struct Pair;",
}
DRAWN = {"README.md": "# Parts & pairs\n\n`src/a.rs`, `a.rs`, `crates/*/src/`, `out.json`\n```sh\n`crates/no.rs`\n```\n", A + "a.rs": ""}

# The check, the files, and with what its messages begin.
CASES: list[tuple[Callable[[Path], tuple[int, list[str]]], dict[str, str], list[str]]] = [
    # A name that is handed on is of the file that defines it; a circle is gone without one of its imports.
    (rust_imports_go_one_way, CIRCLE, [A + "a/pair.rs:2: imports in a circle"]),
    (rust_imports_go_one_way, {**CIRCLE, A + "a/pair.rs": "pub struct Pair;"}, []),
    (rust_imports_go_one_way, {**CIRCLE, A + "a/mod.rs": "mod part;\nmod pair;\npub use part::*;\npub struct Shape;"}, []),
    # All of a module is handed on, a name of a group is another one here, a module within the file has its own `super`.
    (
        rust_imports_go_one_way,
        {
            A + "lib.rs": "mod a;\nmod b;\npub use a::*;",
            A + "a.rs": "use crate::b::{self as other, f as _};\npub const fn g() {}",
            A + "b.rs": "mod inner {\n    pub(crate) fn h() { super::super::g() }\n}",
        },
        [A + "a.rs:1: imports in a circle"],
    ),
    # Tests, comments, what is in quotes, and a module within the file import nothing.
    (
        rust_imports_go_one_way,
        {
            A + "lib.rs": "mod a;\npub fn f() {}\nfn g() { crate::a::b() }",
            A + "a.rs": "/// Of [crate::f].\n"
            "/* /* */ use crate::f; */ fn b<'a>() -> char { r#\"use crate::f;\"#; \"\\\" crate::f\"; '\"' }\n"
            "#[cfg(test)]\n#[allow(unused)]\nuse crate::{f};\n#[cfg(test)]\nconst C: S = S {}.of(crate::f);\n"
            "#[cfg(all(test, unix))]\nmod tests { fn c() { crate::f() } }\nmod d { fn e() { super::b() } }",
            A + "a/tests.rs": "use crate::tests::g;",
            A + "tests.rs": "use crate::a::tests::h;",
        },
        [],
    ),
    (
        documentation_names_its_subject,
        {A + "lib.rs": "/// Offsets of a line.\n//! Whatever is left.\n    /// The same of arcs.\n// What is left.\n//! Of two."},
        [A + "lib.rs:3: begin with a noun", A + "lib.rs:5: begin with a noun"],
    ),
    (
        double_double_is_named_by_formulas_only,
        {KERNEL + "number.rs": "use self::dd::Dd;", KERNEL + "a.rs": "use crate::number::{\n    Dd as Number};"},
        [KERNEL + "a.rs:2: `Dd` is named"],
    ),
    (
        constants_are_explained_and_few,
        {
            KERNEL + "a.rs": "/// Two.\n#[inline]\npub(crate) const A: f64 = 2.0;\nconst N: usize = 1;\nconst B: f64 = 1.0;\n"
            "trait T {\n    const C: f64;\n}\nimpl<X: for<'a> F<'a>> T for S {\n    const C: f64 = 1.0;\n}\n"
            "impl S {\n    const D: f64 = 1.0;\n    #[cfg(test)]\n    const E: f64 = 1.0;\n}\n"
            "fn f() {\n    const G: f64 = 1.0;\n}"
        },
        [f"{KERNEL}a.rs:{line}: {name} has no" for line, name in ((5, "B"), (13, "D"), (18, "G"))],
    ),
    (
        constants_are_explained_and_few,
        {KERNEL + "a.rs": "".join(f"/// {i}.\nconst A{i}: f64 = 0.0;\n" for i in range(MOST_CONSTANTS + 1))},
        [f"{KERNEL[:-1]}: {MOST_CONSTANTS + 1} constants"],
    ),
    # The type alone, over several lines; not what is a comment.
    (
        typescript_imports_go_one_way,
        {
            UI + "a.ts": 'import {\n  type B,\n} from "./b.js";\n// import "./c.js";',
            UI + "b.ts": 'export * from "./c.js";\nexport type B = "//";',
            UI + "c.ts": 'type A = import("./a.js").A;',
        },
        [UI + "a.ts:3: imports in a circle"],
    ),
    (
        python_imports_go_one_way,
        {
            PACKAGE + "__init__.py": "from ._a import a",
            PACKAGE + "_a.py": "from . import _b\na = 1",
            PACKAGE + "_b.py": "def f():\n    from ._a import a\n",
            PACKAGE + "_c.py": "from . import a",
        },
        [PACKAGE + "_a.py:1: imports in a circle"],
    ),
    (documents_name_files_that_exist, {**DRAWN, "docs/a.md": "[a](../README.md#parts--pairs) ![](https://a.b)\n`build/x/`", ".gitignore": "/a/build/"}, []),
    (
        documents_name_files_that_exist,
        {**DRAWN, "docs/a.md": "[a](a.svg), [b](#b)\n[c](../README.md#parts)\n`crates/b`, `other.rs`, `b/`"},
        ["docs/a.md:1: there is no such file: a.svg", "docs/a.md:1: there is no such heading", "docs/a.md:2: there is no such heading"]
        + [f"docs/a.md:3: there is no {path}" for path in ("crates/b", "other.rs", "b/")],
    ),
]  # fmt: skip


def self_test() -> tuple[int, list[str]]:
    wrong = []
    for number, (check, files, expected) in enumerate(CASES, 1):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            found = sorted(check(root)[1])
        if len(found) != len(expected) or not all(map(str.startswith, found, sorted(expected))):
            wrong.append(f"case {number}, {check.__name__}: expected {expected}, found {found}")
    return len(CASES), wrong
