"""sweep.py - what widths cost: visits and wrong pixels of a scene in four profiles
SPDX-License-Identifier: Apache-2.0

python3 sweep.py SCENE.nff"""
import sys

import sphaera

scene = sphaera.read(sys.argv[1])
frames = {profile: scene.build(profile=profile, width=64, height=48).render()
          for profile in ("reference", "fine", "standard", "draft")}
for profile, frame in frames.items():
    wrong = (frame.id != frames["reference"].id).sum()
    print(f"{profile:9} {frame.counters['node_visits']:8} visits, "
          f"{wrong} pixels see another primitive")
