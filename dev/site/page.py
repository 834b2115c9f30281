"""The page of a model in a folder of pages: what all have in common is beside it, and what it computes fast is left out."""

import json
import re
from pathlib import Path

# What pages share, as `cspace export` writes it, and the file that holds it. The kernel is with the script of the worker.
SHARED = {
    "style.js": re.compile(r"<style>.*?</style>", re.S),
    "kernel.js": re.compile(r'<script type="text/plain" id="worker">.*?</script><script [^>]* id="kernel">[^<]*</script>', re.S),
    "page.js": re.compile(r"<script>.*?</script>", re.S),
}
SCENE = re.compile(r'(<script type="application/json" id="scene">)([^<]*)(</script>)')

# A space that the command computes faster than this is computed in the page (s).
FAST = 0.1
# A slower one too, where it takes longer to load: a page computes so many times slower than the command,
SLOWER = 3
# and loads so much of a space in a second (bytes).
LOADED = 1e6


def scene(page: str) -> dict:
    """All that a page shows, as docs/page.md says."""
    return json.loads(SCENE.search(page)[2])


def pays(pair: dict) -> bool:
    """Whether a page has the space of a pair, and does not compute it."""
    return pair["seconds"] >= FAST and SLOWER * pair["seconds"] > len(pair["space"]) / LOADED


def shared(page: str, folder: Path, links: str) -> str:
    """The page with links, and with its style, kernel and script in files beside it. Unlike a request, a script also loads from disk."""
    for name, pattern in SHARED.items():
        [piece] = pattern.findall(page)
        written = f"document.write({json.dumps(piece)});\n"
        file = folder / name
        if not file.exists() or file.read_text("utf-8") != written:
            file.write_text(written, "utf-8")
        page = page.replace(piece, f'<script src="{name}"></script>')
    shown = scene(page)
    for pair in shown["pairs"]:
        if pair["space"] is not None and not pays(pair):
            pair |= {"space": None, "bands": []}
    text = json.dumps(shown, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")
    page = SCENE.sub(lambda found: found[1] + text + found[3], page)
    page = page.replace('<header id="bar">', f'<header id="bar">\n  <nav id="gallery">{links}</nav>', 1)
    return page.replace("script-src ", "script-src 'self' file: ", 1)
