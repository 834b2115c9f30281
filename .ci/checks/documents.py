"""Documents name files that exist: by links, and by paths in backticks.

A span in backticks is a path if it has no blank in it, and

- a slash, and it ends with a slash or with the ending of a source, or begins with a folder of the repository; or
- it is the bare name of a file in Rust or TypeScript.

It exists if some file or folder of the repository has it at its end, so that it may be given from wherever the document says. `*` stands for
part of a name. What has one of <>{}$~ in it or begins with / or a protocol is none, nor is anything in a block of code.
"""

import os
import re
from fnmatch import fnmatchcase
from pathlib import Path
from urllib.parse import unquote

DOCUMENTS = [
    "README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "SECURITY.md",
    "docs/*.md", "crates/*/README.md", "dev/*/README.md", "models/**/README.md",
]  # fmt: skip
FOLDERS = ("crates/", "dev/", "docs/", "models/", "tests/", ".ci/", ".github/")
ENDINGS = ("/", ".rs", ".toml", ".ts", ".py", ".md", ".json")
SKIPPED = {".git", "target", "node_modules", "__pycache__"}

FENCE = re.compile(r"^(\s*)(```+|~~~+).*?^\s*\2[ \t]*$", re.M | re.S)
SPAN = re.compile(r"`([^`\n]+)`")
LINK = re.compile(r"\]\(<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\)|^\[[^\]]+\]:\s*(\S+)", re.M)
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*$", re.M)


def without_code(text: str) -> str:
    """The text without blocks of code, with as many lines."""
    return FENCE.sub(lambda m: "\n" * m[0].count("\n"), text)


def anchors(text: str) -> set[str]:
    """The anchors that GitHub gives to the headings of a document."""
    found: set[str] = set()
    for heading in HEADING.findall(without_code(text)):
        shown = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        slug = re.sub(r"[^\w\- ]", "", shown.lower()).replace(" ", "-")
        number = 0
        while (name := f"{slug}-{number}" if number else slug) in found:
            number += 1
        found.add(name)
    return found


def is_path(span: str) -> bool:
    if re.search(r"[\s<>{}$~]|://|^/", span):
        return False
    if "/" not in span:
        return re.fullmatch(r"\w[\w.-]*\.(rs|ts)", span) is not None
    return span.endswith(ENDINGS) or span.startswith(FOLDERS)


def paths(root: Path) -> list[str]:
    """All files and folders, without those that builds leave."""
    found = []
    for folder, folders, files in os.walk(root):
        folders[:] = [f for f in folders if f not in SKIPPED]
        found += [Path(folder, name).relative_to(root).as_posix() for name in folders + files]
    return found


def ends(path: str) -> list[str]:
    """What a path may be called: a/b/c, b/c and c."""
    parts = path.split("/")
    return ["/".join(parts[i:]) for i in range(len(parts))]


def ignored(root: Path) -> list[str]:
    """What git ignores at a certain place: commands make it."""
    lines = (root / ".gitignore").read_text(encoding="utf-8").split() if (root / ".gitignore").exists() else []
    return [line.strip("/") for line in lines if "/" in line.strip("/")]


class Repository:
    """What there is to name."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.made = ignored(root)
        self.ends = {end for path in paths(root) for end in ends(path)}
        self.made_ends = {end for path in self.made for end in ends(path)}

    def has(self, document: Path, span: str) -> bool:
        """Whether something has a path at its end, or a command makes it."""
        path = span.rstrip("/")
        if path.startswith("."):
            return (document.parent / path).exists() or path in self.ends
        if "*" in path:
            return any(fnmatchcase(end, path) for end in self.ends)
        parts = path.split("/")
        return path in self.ends or any("/".join(parts[:i]) in self.made_ends for i in range(1, len(parts) + 1))

    def wrong(self, document: Path, link: str) -> str | None:
        """What is wrong with a link to a file."""
        to, _, anchor = unquote(link).partition("#")
        path = Path(os.path.normpath(document.parent / to)) if to else document
        if not path.exists():
            is_made = any(fnmatchcase(os.path.relpath(path, self.root), made) for made in self.made)
            return None if is_made else "there is no such file"
        if anchor and path.suffix == ".md" and anchor not in anchors(path.read_text(encoding="utf-8")):
            return "there is no such heading"
        return None


def documents_name_files_that_exist(root: Path) -> tuple[int, list[str]]:
    # Several may be links to one.
    documents = sorted({path.resolve() for pattern in DOCUMENTS for path in root.glob(pattern)})
    repository = Repository(root)
    count, wrong = 0, []
    for document in documents:
        text = without_code(document.read_text(encoding="utf-8"))

        def place(match: re.Match[str]) -> str:
            return f"{document.relative_to(root)}:{text.count(chr(10), 0, match.start()) + 1}"

        for match in SPAN.finditer(text):
            if is_path(match[1]):
                count += 1
                if not repository.has(document, match[1]):
                    wrong.append(f"{place(match)}: there is no {match[1]}")
        for match in LINK.finditer(SPAN.sub(lambda m: "`" * len(m[0]), text)):
            link = match[1] or match[2]
            if not re.match(r"[a-z]+:", link):
                count += 1
                if message := repository.wrong(document, link):
                    wrong.append(f"{place(match)}: {message}: {link}")
    return count, wrong
