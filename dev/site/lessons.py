"""Lessons of `lessons.toml`, answered by the program."""

import html
import math
import shlex
from collections.abc import Callable

# So many digits of a number are shown.
DIGITS = 4

# Keys of a lesson that are no values.
TEXTS = {"title", "model", "question", "choices", "answer", "decides"}

Ask = Callable[[list[str]], dict]


def found(answer: dict, place: str) -> object:
    """What is at a place of an answer."""
    value: object = answer
    for key in place.split("/"):
        if key == "#":
            value = len(value)
        elif "=" in key:
            name, text = key.split("=", 1)
            [value] = [item for item in value if item[name] == text]
        else:
            value = value[int(key) if isinstance(value, list) else key]
    return value


def value(of: dict, model: str, ask: Ask) -> float | str:
    """The value as the program answers: a text, or the sum of the numbers at its places, of angles in degrees."""
    answer = ask([word.format(model) for word in shlex.split(of["ask"])])
    values = [-found(answer, place[1:]) if place.startswith("-") else found(answer, place) for place in of["at"]]
    if isinstance(values[0], str):
        return values[0]
    total = sum(values)
    return math.degrees(total) if of["unit"] == "deg" else total


def shown(of: dict, is_now: float | str) -> str:
    if isinstance(is_now, str):
        return is_now
    unit = {"deg": "°", "": ""}.get(of["unit"], f" {of['unit']}")
    return f"{is_now:.{DIGITS}g}{unit}"


def right(lesson: dict, decides: float | str) -> int:
    """The choice that the value makes right; an error if it makes none right."""
    for i, choice in enumerate(lesson["choices"]):
        if choice["is"] == decides if "is" in choice else "below" not in choice or decides < choice["below"]:
            return i
    raise SystemExit(f"error: lesson {lesson['title']}: no choice is right for {decides}; change its choices in dev/site/lessons.toml")


def section(lesson: dict, model: str, ask: Ask, picture: str, page: str) -> str:
    """A lesson as HTML: the answer is there, and not shown until a choice is made."""
    values = {name: value(of, model, ask) for name, of in lesson.items() if name not in TEXTS}
    texts = {name: shown(lesson[name], is_now) for name, is_now in values.items()}
    chosen = right(lesson, values[lesson["decides"]])
    buttons = "".join(
        f'<button type="button"{" data-right" if i == chosen else ""}>{html.escape(choice["says"])}</button>\n'
        for i, choice in enumerate(lesson["choices"])
    )
    answer = html.escape(lesson["answer"].format(**texts))
    return f"""<section class="lesson">
<h2>{html.escape(lesson["title"])}</h2>
<a href="{page}">{picture}</a>
<div><p>{html.escape(lesson["question"])}</p>
<div class="choices">{buttons}</div>
<div class="answer" hidden><p><b></b> {answer}</p><p><a href="{page}">Move the parts and look at their space</a></p></div></div>
</section>
"""
