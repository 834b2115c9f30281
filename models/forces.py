"""What sets the parts of a model in motion, as text: gravity, drives, loads and springs. Masses and starts are keys of parts.

Lengths are in mm, masses in kg and times in s, so forces are in mN, torques in mN mm, and stiffnesses of 1 N/mm are 1000.
"""

GRAVITY = 9810.0  # mm/s²
STEEL = "density = 7.85e-5 # steel, 10 thick"
PLASTIC = "density = 1.05e-5 # ABS, 10 thick"


def placed(x, y, degrees=0.0):
    """The line of a part that says where it starts."""
    return f'start = [{number(x)}, {number(y)}, "{degrees:g}deg"]'


def number(x):
    return repr(0.0 if abs(x) < 1e-14 else float(x))


def comment(text, indent=""):
    return "".join(f"{indent}# {line}".rstrip() + "\n" for line in text.strip("\n").splitlines())


class Forces:
    """Adds to the text `out` of a model."""

    def show(self, question, pair=None):
        """What the page asks first, of which pair; the model's only one if none is given. Comes before the parts."""
        of = f'pair = ["{pair[0]}", "{pair[1]}"], ' if pair else ""
        self.out += f'show = {{ {of}question = "{question}" }}\n'

    def world(self, gravity=None, friction=None, restitution=None):
        """What goes for all parts. Comes before them."""
        pull = f"[{gravity[0]:g}, {gravity[1]:g}]" if gravity else None
        for key, value in (("gravity", pull), ("friction", friction), ("restitution", restitution)):
            if value is not None:
                self.out += f"{key} = {value}\n"
        return self

    def weighed(self, file, text, world, masses):
        """The same model under another name, with masses: `world` are lines that go for all parts, `masses` lines of parts by name."""
        self.file, self.name = file, f"{self.name}, with masses"
        head, parts = self.out.split('\nname = "', 1)
        parts = parts.split('"\n', 1)[1].replace('unit = "mm"\n', 'unit = "mm"\n' + "".join(f"{line}\n" for line in world), 1)
        for part, lines in masses.items():
            before = f'[[part]]\nname = "{part}"\n'
            assert parts.count(before) == 1, f"no part {part}"
            parts = parts.replace(before, before + "".join(f"{line}\n" for line in lines))
        self.out = f'{head}#\n{comment(text)}\nname = "{self.name}"\n{parts}'
        return self

    def drive(self, part, rate, text=""):
        self.out += "\n" + comment(text) + f'[[drive]]\npart = "{part}"\nrate = "{rate}"\n'
        return self

    def table(self, part, points, text=""):
        rows = ", ".join(f"[{t:g}, {u}]" for t, u in points)
        self.out += "\n" + comment(text) + f'[[drive]]\npart = "{part}"\ntable = [{rows}]\n'
        return self

    def force(self, part, force, text="", at=None):
        """Acts in the centre of mass, or in a point of the part."""
        where = f"at = [{number(at.real)}, {number(at.imag)}]\n" if at is not None else ""
        self.out += "\n" + comment(text) + f'[[load]]\npart = "{part}"\nforce = [{force[0]}, {force[1]}]\n' + where
        return self

    def torque(self, part, torque, text=""):
        self.out += "\n" + comment(text) + f'[[load]]\npart = "{part}"\ntorque = {torque}\n'
        return self

    def spring(self, part, at, stiffness, length, damping=0, text=""):
        """From a point of a part to a point of the ground, or of another part if `part` is a pair of names."""
        names = ", ".join(f'"{p}"' for p in ([part] if isinstance(part, str) else part))
        points = ", ".join(f"[{number(p.real)}, {number(p.imag)}]" for p in at)
        self.out += "\n" + comment(text) + f'[[spring]]\nparts = [{names}]\nat = [{points}]\nstiffness = {stiffness:g}\n'
        self.out += f"length = {number(length)}\n" + (f"damping = {damping:g}\n" if damping else "")
        return self

    def mounted(self, part, points, stiffness, damping, shift=0, text=""):
        """Springs without length in points of a part, which hold them where they are drawn, or `shift` from there. Two hold a part
        in its place and its direction; one is a bearing, about which the part turns."""
        for i, p in enumerate(points):
            self.spring(part, (complex(p), p + shift), stiffness, 0, damping, text if i == 0 else "")
        return self

    def torsion(self, parts, stiffness, angle="0deg", damping=0, text=""):
        names = ", ".join(f'"{p}"' for p in parts)
        self.out += "\n" + comment(text) + f'[[spring]]\ntype = "torsion"\nparts = [{names}]\nstiffness = {stiffness:g}\n'
        self.out += f'angle = "{angle}"\n' + (f"damping = {damping:g}\n" if damping else "")
        return self

    def brake(self, part, damping, text=""):
        self.out += "\n" + comment(text) + f'[[spring]]\ntype = "torsion"\nparts = ["{part}"]\ndamping = {damping}\n'
        return self
