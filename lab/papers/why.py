# why.py - why figures and pixels of the papers differ: each asked of the paper's own text
# SPDX-License-Identifier: Apache-2.0
"""Each function works out, in real numbers and without the model, what the paper says, and counts
what of its claim fails and for which reason: {name: value}, which lab/papers/claims.py names. TOOL
makes scenes alone. page.py keeps the values as the table papers.why."""
import json
import math
import subprocess
from collections import namedtuple
from pathlib import Path

from .. import intact
from . import scenes

Ball = namedtuple("Ball", "at radius")
View = namedtuple("View", "eye right up ahead tangent balls planes")  # tangent: of half the height


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def view(lines):
    """Camera, spheres and planes of a scene file, all turned so that the eye is at 0 and looks
    along -z."""
    words = [line.split("#")[0].split() for line in lines]
    said = {w[0]: [float(x) for x in w[1:4]] for w in words
            if w and w[0] in ("from", "at", "up", "angle")}
    ahead = unit(minus(said["at"], said["from"]))
    right = unit(cross(ahead, said["up"]))
    up = cross(right, ahead)

    def turned(point):
        p = minus(point, said["from"])
        return [dot(p, right), dot(p, up), -dot(p, ahead)]
    balls = [Ball(turned([float(x) for x in w[1:4]]), float(w[4])) for w in words
             if w and w[0] == "s"]
    return View([0, 0, 0], right, up, ahead, math.tan(math.radians(said["angle"][0]) / 2), balls,
                [])


def rays(seen, width, height):
    """((x, y), direction) of each pixel's middle."""
    pitch = 2 * seen.tangent / height
    return [((x, y), [(x + 0.5 - width / 2) * pitch, (height / 2 - y - 0.5) * pitch, -1.0])
            for y in range(height) for x in range(width)]


def meets(ball, way):
    """Whether a ray from the eye meets a sphere ahead of it."""
    b, a, c = dot(ball.at, way), dot(way, way), dot(ball.at, ball.at) - ball.radius ** 2
    return b * b - a * c > 0 and (b > 0 or c < 0)


# ---- Borodavka et al., IV: the tree, and what a ray revises of it ----
Node = namedtuple("Node", "ball children")  # children: none of a sphere of the scene


def around(balls):
    """The sphere on the box of some: C = (near + far)/2, R to a corner."""
    low = [min(b.at[i] - b.radius for b in balls) for i in range(3)]
    high = [max(b.at[i] + b.radius for b in balls) for i in range(3)]
    return Ball([(a + b) / 2 for a, b in zip(low, high)], math.dist(low, high) / 2)


def by_fours(nodes, most):
    """Levels of nodes merged by four, in their order; a sphere larger than `most` becomes it."""
    while len(nodes) > 1:
        merged = []
        for i in range(0, len(nodes), 4):
            ball = around([n.ball for n in nodes[i:i + 4]])
            merged.append(Node(most if ball.radius > most.radius else ball, nodes[i:i + 4]))
        nodes = merged
    return nodes[0]


def by_z(balls):
    """The paper's: sorted from near to far by z alone."""
    leaves = [Node(b, []) for b in sorted(balls, key=lambda b: -b.at[2])]
    return by_fours(leaves, around(balls))


def by_space(balls):
    """As many levels, but each of a node's four parts is a half of a half, across the longest side
    of the box of its centres."""
    def halves(part):
        low, high = ([f(b.at[i] for b in part) for i in range(3)] for f in (min, max))
        axis = max(range(3), key=lambda i: high[i] - low[i])
        part = sorted(part, key=lambda b: b.at[axis])
        return part[:(len(part) + 1) // 2], part[(len(part) + 1) // 2:]

    def node(part):
        if len(part) == 1:
            return Node(part[0], [])
        parts = [q for half in halves(part) for q in (halves(half) if len(half) > 1 else [half])]
        return Node(around(part), [node(q) for q in parts if q])
    return node(balls)


def inner(node):
    """All nodes that are no spheres of the scene."""
    if node.children:
        yield node
        for child in node.children:
            yield from inner(child)


def cover(root):
    """How many inner spheres a line through the root's meets in the mean: a line that meets a ball
    meets one within it with the ratio of their discs."""
    return sum((n.ball.radius / root.ball.radius) ** 2 for n in inner(root))


def revised(node, way):
    """(a sphere of the scene was met, spheres tested, nodes entered): from left to right, one level
    down where a node is met, until a sphere of the scene is."""
    if not meets(node.ball, way):
        return False, 1, 0
    if not node.children:
        return True, 1, 0
    tested, entered = 1, 1
    for child in node.children:
        hit, t, e = revised(child, way)
        tested, entered = tested + t, entered + e
        if hit:
            return True, tested, entered
    return False, tested, entered


def at_once(root, way):
    """Spheres tested, the root's too, where all children of a node are tested before one is
    entered, as the core does."""
    tested, stack = 1, [root]
    while stack:
        node = stack.pop()
        met = [child for child in node.children if meets(child.ball, way)]
        tested += len(node.children)
        if any(not child.children for child in met):
            break
        stack += met[::-1]
    return tested


def search(tool, folder):
    """Tests and nodes of the rays that end on a sphere; how many enter nodes in vain, which the
    paper's bounds have none of."""
    found = {}
    for name, lines in (("column4096", scenes.column(4096)), ("random4096", None)):
        if lines is None:
            path = Path(folder, f"why-{name}.nff")
            subprocess.run([tool, "gen", "random", "-n", "4096", "-o", path], check=True,
                           stdout=subprocess.DEVNULL)
            lines = path.read_text("utf-8").splitlines()
        seen = view(lines)
        root = by_z(seen.balls)
        levels = math.ceil(math.log(len(seen.balls), 4))
        ends = [r for r in (revised(root, way) for _, way in rays(seen, 64, 36)) if r[0]]
        most = 4 * levels + 1
        alone = [r for r in ends if r[2] == levels]  # that enter one node a level, as is claimed
        found.update({
            f"{name}_tests": f"{sum(r[1] for r in ends) / len(ends):.0f}",
            f"{name}_entered": f"{sum(r[2] for r in ends) / len(ends):.1f}",
            f"{name}_levels": levels,
            f"{name}_above": f"{100 * sum(r[1] > most for r in ends) / len(ends):.0f}",
            f"{name}_alone": f"{100 * len(alone) / len(ends):.0f}",
            f"{name}_alone_most": max((r[1] for r in alone), default="-"),
            f"{name}_cover": f"{cover(root):.0f}",
            f"{name}_cover_space": f"{cover(by_space(seen.balls)):.0f}"})
    return found


# ---- Borodavka et al., V: the root sphere's pixels ----
def smallest(balls):
    """The smallest sphere around some, nearly: a centre walks towards the farthest of them."""
    at = list(balls[0].at)
    for i in range(1, 20000):
        far = max(balls, key=lambda b: math.dist(at, b.at) + b.radius)
        gap = math.dist(at, far.at)
        step = (gap + far.radius) / (i + 1) / gap if gap else 0
        at = [a + step * (b - a) for a, b in zip(at, far.at)]
    return Ball(at, max(math.dist(at, b.at) + b.radius for b in balls))


def hull(points):
    """The convex hull, counter-clockwise."""
    points = sorted(set(points))

    def half(points):
        line = []
        for p in points:
            while len(line) > 1 and ((line[-1][0] - line[-2][0]) * (p[1] - line[-2][1])
                                     - (line[-1][1] - line[-2][1]) * (p[0] - line[-2][0])) <= 0:
                line.pop()
            line.append(p)
        return line[:-1]
    return half(points) + half(points[::-1])


def within(polygon, p):
    return all((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) >= -1e-9
               for a, b in zip(polygon, polygon[1:] + polygon[:1]))


def spans(marked):
    """From first to last in each row, then in each column."""
    for axis in 0, 1:
        lines = {}
        for p in marked:
            lines.setdefault(p[1 - axis], []).append(p[axis])
        marked = {(at, line) if axis == 0 else (line, at) for line, found in lines.items()
                  for at in range(min(found), max(found) + 1)}
    return marked


def outline(width, height, points):
    """Of view `centred` the pixels that see the sphere around all and that the paper's steps leave
    out, and those of them that straight lines between the same points would have found."""
    seen = view(Path("scenes/views/centred.nff").read_text("utf-8").splitlines())
    ball, pitch = smallest(seen.balls), 2 * seen.tangent / height
    marked, exact = set(), []
    for i in range(points):
        alpha = math.pi * i / (points - 1)
        for j in range(points):
            beta = 2 * math.pi * j / points
            x, y, z = (ball.at[k] + ball.radius * part for k, part in enumerate((
                math.sin(alpha) * math.cos(beta), math.sin(alpha) * math.sin(beta),
                math.cos(alpha))))
            at = x / -z / pitch + width / 2 - 0.5, height / 2 - 0.5 - y / -z / pitch
            exact.append(at)
            marked.add((math.floor(at[0] + 0.5), math.floor(at[1] + 0.5)))
    marked = spans(marked)
    marked = {(x + dx, y + dy) for x, y in marked for dx in (-1, 0, 1) for dy in (-1, 0, 1)}
    left_out = [p for p, way in rays(seen, width, height) if meets(ball, way) and p not in marked]
    joined = hull([(round(x, 9), round(y, 9)) for x, y in exact])
    return len(left_out), sum(within(joined, p) for p in left_out)


def separated(_tool, _folder):
    left_out, between = outline(160, 90, 16)
    return {"outline_left_out": left_out, "outline_between": between,
            "outline_64": outline(160, 90, 64)[0], "outline_hd": outline(1280, 720, 16)[0],
            **square()}


def square():
    """V.C: the angle from which on C + 1.4 R lies within the outline; pixels of `off_axis` outside
    of the square that see the sphere around all, or one of the scene; where its points stand."""
    seen = view(Path("scenes/views/off_axis.nff").read_text("utf-8").splitlines())
    ball, (width, height) = smallest(seen.balls), (160, 90)
    depth, reach = -ball.at[2], 1.4 * ball.radius
    half = seen.tangent / height  # of a pixel: the points stand on whole ones
    slopes = [[(ball.at[i] + s * reach) / depth + s * half for s in (-1, 1)] for i in (0, 1)]
    beyond = []
    for _, way in rays(seen, width, height):
        if meets(ball, way) and any(not s[0] <= way[i] <= s[1] for i, s in enumerate(slopes)):
            beyond.append(way)
    lost = sum(any(meets(b, way) for b in seen.balls) for way in beyond)
    farthest = max(abs(s) for pair in slopes for s in pair)
    # the line from the eye through a point 1.4 R beside the centre passes that at 1.4 R cos(angle)
    return {"square_angle": f"{math.degrees(math.acos(1 / 1.4)):.1f}",
            "square_beyond": len(beyond), "square_lost": lost,
            "square_point": f"{math.degrees(math.atan(farthest)):.0f}"}


# ---- Park et al., section 4: P_b ----
def base(_tool, _folder):
    """P_b is where a pixel and a texel have the same area. A wall of 2 by 2 with an image of 256 by
    256 on it, square to the ray, in a frame of 800 by 480 that sees 48 degrees: P_b as it follows
    from that, and by the five steps, for this image and one of twice the side, and in feet."""
    width, height, side = 800, 480, 2.0

    def true(texels, scale=1.0):
        distance = height / 2 / math.tan(math.radians(24))  # of the screen, in pixels
        return distance * side * scale / texels             # a pixel there is as wide as a texel

    def printed(texels, scale=1.0):
        t_xn = texels * texels
        t_xs = t_xn * texels * texels / (width * height)
        return math.sqrt(t_xs / (side * scale) ** 2)
    feet = 3.28084
    def log(x): return f"{math.log2(x):.1f}"
    return {"base_true": log(true(256)), "base_printed": log(printed(256)),
            "base_true_512": log(true(512)), "base_printed_512": log(printed(512)),
            "base_true_feet": log(true(256, feet)), "base_printed_feet": log(printed(256, feet)),
            "base_texels": f"{(printed(256) / true(256)) ** 2:.0f}"}


# ---- Aroxa, Listing 3.5 and Figure 4.4 ----
Cut = namedtuple("Cut", "axis clip_l clip_r left right")


def interval_tree(balls, most):
    """A BIH as the text of III.B has it: planes in the middle of the longest side of the box."""
    def node(part, low, high):
        if len(part) <= most:
            return part
        low, high = list(low), list(high)
        for _ in range(64):
            axis = max(range(3), key=lambda i: high[i] - low[i])
            split = (low[axis] + high[axis]) / 2
            left = [b for b in part if b.at[axis] < split]
            right = [b for b in part if b.at[axis] >= split]
            if left and right:
                clip_l = max(b.at[axis] + b.radius for b in left)
                clip_r = min(b.at[axis] - b.radius for b in right)
                bounds = [list(high), list(low)]
                bounds[0][axis], bounds[1][axis] = clip_l, clip_r
                return Cut(axis, clip_l, clip_r, node(left, low, bounds[0]),
                           node(right, bounds[1], high))
            (high if left else low)[axis] = split
        return part
    low = [min(b.at[i] - b.radius for b in balls) for i in range(3)]
    high = [max(b.at[i] + b.radius for b in balls) for i in range(3)]
    return node(balls, low, high), low, high


def key(ball, way):
    """Where a ray from the eye meets a sphere; infinity: nowhere."""
    b, a, c = dot(ball.at, way), dot(way, way), dot(ball.at, ball.at) - ball.radius ** 2
    disc = b * b - a * c
    return (b - math.sqrt(disc)) / a if disc > 0 and b > 0 else math.inf


def listing(tree, low, high, way, printed, aware):
    """Listing 3.5. printed: branches as it has them; else exchanged, as the text has them. aware:
    `left` is the child that the ray meets first, and its plane is clipL."""
    t_min, t_max = -math.inf, math.inf
    for i in range(3):
        if way[i]:
            ends = sorted((low[i] / way[i], high[i] / way[i]))
            t_min, t_max = max(t_min, ends[0]), min(t_max, ends[1])
        elif not low[i] <= 0 <= high[i]:
            return None
    if t_min > t_max:
        return None
    t_min, best, who, stack = max(0.0, t_min), math.inf, None, [tree]
    while stack:
        current = stack.pop()
        while isinstance(current, Cut):
            slope = way[current.axis] or 1e-300
            t_l, t_r = current.clip_l / slope, current.clip_r / slope
            left, right = current.left, current.right
            if aware and slope < 0:
                t_l, t_r, left, right = t_r, t_l, right, left
            if t_l < t_min and t_r > t_max:
                current = []
            elif t_l < t_min:
                current = left if printed else right
            elif t_r > t_max:
                current = right if printed else left
            else:
                stack.append(right)
                current = left
        for ball in current:
            t = key(ball, way)
            if t < best and t <= t_max:
                best, who = t, ball
    return who


def listings(tool, folder):
    """Pixels of Scenario 1 with 64 spheres at 40 x 68 that Listing 3.5 gives another sphere than a
    look at all spheres does, and the same of a camera on the other side."""
    path = Path(folder, "why-scenario1.nff")
    subprocess.run([tool, "gen", "scenario1", "-n", "64", "--plain", "-o", path], check=True,
                   stdout=subprocess.DEVNULL)
    seen = view(path.read_text("utf-8").splitlines())
    tree, low, high = interval_tree(seen.balls, 1)
    ways = [way for _, way in rays(seen, 40, 68)]
    truth = [min(seen.balls, key=lambda b, w=way: key(b, w)) for way in ways]
    truth = [b if key(b, w) < math.inf else None for b, w in zip(truth, ways)]
    found = {"listing_pixels": len(ways), "listing_seen": sum(b is not None for b in truth)}
    for name, how in (("printed", (True, False)), ("text", (False, False)),
                      ("aware", (False, True))):
        found["listing_" + name] = sum(listing(tree, low, high, way, *how) is not b
                                       for way, b in zip(ways, truth))
    return found


def brute(_tool, _folder):
    """IV.F: brute force takes 2.14 frames a second with 128 spheres, and BIH 16 1495 % more. What
    is no test of a sphere takes no more than that frame, so with 256 spheres there are at most so
    many frames a second; and what a test would have to take for the printed 1.87."""
    frame, fast = 1 / 2.14, 1 / (2.14 * 15.95)
    least = 2 * (frame - fast)
    return {"brute_most": f"{1 / least:.2f}", "brute_rest": f"{1000 * fast:.0f}",
            "brute_less": f"{100 * (1 - (1 / 1.87) / (2 * frame)):.0f}"}


def main(tool, folder):
    found = {}
    for part in search, separated, base, listings, brute:
        found.update(part(tool, folder))
    intact.write(Path(folder, "why.json"), json.dumps(found, indent=1) + "\n")
    for name, value in found.items():
        print(f"{name:24} {value}")
