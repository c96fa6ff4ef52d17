# rays.py - a cloud of balls out of arrays: a batch of rays, the stages of one, a core checked
# SPDX-License-Identifier: Apache-2.0
"""usage: rays.py"""
import numpy as np
import sphaera

rng = np.random.default_rng(1)
balls = np.column_stack([rng.uniform(-3, 3, (200, 3)), rng.uniform(0.1, 0.4, 200)])
scene = sphaera.scene_of(spheres=balls, materials=[[0.9, 0.4, 0.2, 0.7, 0.3, 10, 0, 1]],
                         lights=[[5, 9, 9]], eye=(0, 0, 9), width=96, height=54)
machine = scene.build(profile="standard", progress=lambda done, all_: False)
hits = machine.trace_rays(rng.uniform(-4, 4, (5000, 3)), rng.normal(size=(5000, 3)))
print(f"{(hits.id != sphaera.NONE).mean():.0%} hit, {hits.visits.mean():.1f} visits a ray")
print(f"{machine.core}, {len(machine.memory)} lines, W={machine.parameters['W']}")
stage = next(s for s in machine.pixel(48, 27).stages if s.name == "root")
print(stage.name, *(f"{o.name}={o.word:#x}" for o in stage.operands))

board, frame = sphaera.Scoreboard(machine), machine.render()
for x, y in ((x, y) for y in range(54) for x in range(96)):
    red, green, blue = (int(c) for c in frame.rgb()[y, x])
    board.colour(x, y, red | green << 8 | (blue ^ (x == y == 20)) << 16)    # one is wrong
print(board.end(), "differs:", board.text.splitlines()[0])
