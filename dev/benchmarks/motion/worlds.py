"""pymunk and Box2D as one: rigid bodies, discs and convex polygons about their centres of mass, that fall, strike without bouncing, and rub.

Lengths are metres. Box2D (single precision) is as it comes, with the 8 and 3 iterations that its manual advises, except that nothing is put
to sleep, so that what stands still stands by its contacts. pymunk is tightened, as its contacts may otherwise overlap by 0.1: SLOP, 30
iterations, and what is deeper is put right in one step.
"""

import math

SLOP = 1e-4  # m; pymunk's contacts that overlap by this much are not pushed apart
GRAVITY = 9.81


def rectangle(width, height):
    """The corners of a rectangle about its centre, counter-clockwise."""
    return [(x * width / 2, y * height / 2) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def inertia(shape, mass):
    """The moment of inertia about the centre of a disc, given by its radius, or of a rectangle, given by its corners."""
    return mass * (shape**2 / 2 if isinstance(shape, float) else (abs(complex(*shape[0])) ** 2) / 3)


class Pymunk:
    name = "pymunk"

    def __init__(self, friction):
        import pymunk

        self.of, self.friction, self.space = pymunk, math.sqrt(friction), pymunk.Space()  # those of two shapes are multiplied
        self.space.gravity = (0, -GRAVITY)
        self.space.iterations, self.space.collision_slop, self.space.collision_bias = 30, SLOP, 0.0

    def add(self, shape, mass, place, angle=0.0):
        """A body that falls, or with a mass of 0 one that stands."""
        body = self.of.Body(mass, inertia(shape, mass)) if mass else self.of.Body(body_type=self.of.Body.STATIC)
        body.position, body.angle = place, angle
        made = self.of.Circle(body, shape) if isinstance(shape, float) else self.of.Poly(body, shape)
        made.friction, made.elasticity = self.friction, 0.0
        self.space.add(body, made)
        return body

    def step(self, seconds):
        self.space.step(seconds)

    @staticmethod
    def state(body):
        """Place and angle of a body, and their rates."""
        return (*body.position, body.angle, *body.velocity, body.angular_velocity)


class Box2D:
    name = "Box2D"

    def __init__(self, friction):
        import Box2D

        self.of, self.friction = Box2D, friction  # of two shapes it is the root of the product
        self.world = Box2D.b2World(gravity=(0, -GRAVITY), doSleep=False)

    def add(self, shape, mass, place, angle=0.0):
        """A body that falls, or with a mass of 0 one that stands."""
        made = self.of.b2CircleShape(radius=shape) if isinstance(shape, float) else self.of.b2PolygonShape(vertices=shape)
        fixture = self.of.b2FixtureDef(shape=made, density=1.0, friction=self.friction, restitution=0.0)
        create = self.world.CreateDynamicBody if mass else self.world.CreateStaticBody
        body = create(position=place, angle=angle, fixtures=fixture)
        if mass:
            body.massData = self.of.b2MassData(mass=mass, center=(0, 0), I=inertia(shape, mass))
        return body

    def step(self, seconds):
        self.world.Step(seconds, 8, 3)

    @staticmethod
    def state(body):
        """Place and angle of a body, and their rates."""
        return (*body.position, body.angle, *body.linearVelocity, body.angularVelocity)


WORLDS = {world.name: world for world in (Pymunk, Box2D)}
