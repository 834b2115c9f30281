"""A view of a space for notebooks. Needs anywidget: the slice and all answers are computed in Python, and the page only shows them."""

from typing import Any

import numpy as np

from . import _draw
from ._optional import optional
from ._space import ContactSpace

anywidget: Any = optional("anywidget")
traitlets: Any = optional("traitlets")

# The page: a slider for the orientation, the picture, and what is told of the position that is clicked.
_PAGE = """
function render({ model, el }) {
  const make = (name, keys = {}) => Object.assign(document.createElement(name), keys);
  const [lo, hi] = model.get("window");
  const slider = make("input", { type: "range", min: lo, max: hi, step: (hi - lo) / 720, value: model.get("theta") });
  const label = make("span"), picture = make("div"), told = make("pre");
  slider.style.width = "300px";
  slider.oninput = () => { model.set("theta", Number(slider.value)); model.save_changes(); };
  picture.onclick = (event) => {
    const svg = picture.querySelector("svg");
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    model.set("at", [x, -y]);
    model.save_changes();
  };
  const show = () => {
    label.textContent = " θ = " + (model.get("theta") * 180 / Math.PI).toFixed(2) + "°";
    picture.innerHTML = model.get("svg");
    told.textContent = model.get("told");
  };
  for (const name of ["theta", "svg", "told"]) model.on("change:" + name, show);
  el.append(slider, label, picture, told);
  show();
}
export default { render };
"""


class View(anywidget.AnyWidget):  # type: ignore[misc]
    """The slice at the orientation `theta`, and what is told of the position `at`: both are set by the page, or in Python."""

    _esm = _PAGE
    window = traitlets.Tuple().tag(sync=True)
    theta = traitlets.Float(0.0).tag(sync=True)
    at = traitlets.List(traitlets.Float(), [0.0, 0.0], minlen=2, maxlen=2).tag(sync=True)
    svg = traitlets.Unicode().tag(sync=True)
    told = traitlets.Unicode().tag(sync=True)

    def __init__(self, space: ContactSpace) -> None:
        self.space = space
        window = space.window or (-np.pi, np.pi)
        # Two parts on axes have no slices: they are refused here, in words.
        space.slice(window[0])
        super().__init__(window=window, theta=0.0 if window[0] <= 0 <= window[1] else window[0])
        self._show()
        self.observe(self._show, ["theta", "at"])

    def _show(self, _change: Any = None) -> None:
        space, (x, y) = self.space, self.at
        loops = space.slice(self.theta)
        moving = space.moving.outline.moved(x, y, self.theta)
        outlines = [(loops, _draw.BLOCKED), (space.fixed.outline, _draw.FILL), (moving, _draw.MOVING)]
        boxes = np.array([one.bounds for one, _ in outlines if len(one)])
        bounds = (*boxes[:, :2].min(axis=0), *boxes[:, 2:].max(axis=0))
        self.svg = _draw.svg(outlines, bounds)
        self.told = self._words((x, y, self.theta))

    def _words(self, q: tuple[float, float, float]) -> str:
        """The class of a configuration and its play."""
        space, unit = self.space, f" {self.space.unit}" if self.space.unit else ""
        found = space.classify(q)
        words = [f"x = {q[0]:.6g}, y = {q[1]:.6g}: {found}"]
        if found == 0:
            words.append(f"clearance {space.clearance(q):.6g}{unit}")
            for name, play in space.play(q).items():
                factor, of = (180 / np.pi, "°") if name == "theta" else (1.0, unit)
                words.append(f"{name} from {play.lower * factor:.6g} to {play.upper * factor:.6g}{of}")
        return "\n".join(words)
