# claims.py - what the three papers claim, and what became of it
# SPDX-License-Identifier: Apache-2.0
"""A row for each item of a paper: where it stands, what the paper says, what is found here and why,
where it is built (a file of cmodel/; a module of rtl/; - : in none), what tells the reason, of
ORACLES, the command that shows it, and a word of VERDICTS. Names in braces are rows of
docs/results/data/papers.tsv, of MEASURED, which page.py made of this experiment's runs, or rates of
told(); other numbers are of the page that the row links."""
import re
from pathlib import Path

from .. import clocks
from ..pages import data, markdown, rates
from ..pages.told import by_hand
from .measure import PARK_CORE, PARTS, PARTS_CORE

MEASURED = "values", "profiles", "shaped", "park", "bound", "why"
VERDICTS = {
    "same": "found here too",
    "same in kind": "the same way round, with other figures",
    "other": "found otherwise, on the same terms",
    "refuted": "shown to be wrong",
    "not told": "the paper leaves out what is needed to repeat it",
    "built": "no figure is claimed; it is there",
    "not built": "it is not there, and why",
}
# what a row's reason rests on: none is a guess
ORACLES = {
    "count": "counted by the run: tests, visits, operations, bytes, points",
    "limit": "the part that binds, as the run of the RTL names it",
    "numbers": "worked out in real numbers, without the model (`lab/papers/why.py`)",
    "reference": "the scene in doubles, as it is written",
    "bits": "equal bit by bit: RTL and model, or exact integers and the paper's rule",
    "text": "follows from the paper's own words",
}

BORODAVKA = [
    ("II", "SaarCOR, RPU, SGRT and HART",
     "what they publish stands beside our rates "
     "([speed_and_area.md](speed_and_area.md#frames-a-second))",
     "-; rt_core", "text", "make bench", "built"),
    ("III", "viewpoint on the z axis, screen parallel to xOy, 1280x720",
     "any camera, turned into this frame by [build](../design/builder.md#grid); up to 16383 x "
     "16383",
     "builder/grid/axes.c; rt_registers", "bits", "make test ONLY=test_grid", "built"),
    ("IV.A, B", "sort by z, merge by 4; a sphere that is larger than the one around all is "
     "replaced by it",
     "[`--tree paper`](../design/builder.md#the-trees), and what the last rule saves "
     "([trees.md](trees.md#the-rule-of-the-largest-box)); also a tree that does not degrade",
     "builder/tree/paper.c; rt_traverse", "count", "make swept", "same"),
    ("IV", "left to right, stop at the first leaf",
     "effect [FIRST](../design/model.md#effects); otherwise near first, pruned by the best hit",
     "trace/traverse.c; rt_first", "bits", "make test ONLY=test_interpenetrate", "built"),
    ("V.A", "a matrix projects from a viewpoint X_v, Y_v, Z_v to a screen that stays",
     "the registers of the first ray are an oblique frustum, for every way of separation, pairs of "
     "eyes and walls ([tool.md](../reference/tool.md#eyes-screens-and-walls)): {moved_least} to "
     "{moved_most} dB from a part of a larger picture that knows of no shift, below",
     "scene/window.c; rt_pixel_scan", "reference", "make test ONLY=test_window", "built"),
    ("V.B", "at least 64 points, that is 16 meridians and 16 parallels",
     "16 times 16 are 256; 64 are 8 times 8. Here `--bg-points N` are N of each, and 16 if it is "
     "not given", "builder/background/outline.c; rt_spans", "text", "make background", "refuted"),
    ("IV.B", "a tree of N spheres has log4(N), rounded up, and 1 levels",
     "so it has in all of {search_scenes} scenes of 5 to 1 000 000 spheres",
     "builder/tree/paper.c; rt_traverse", "count",
     "make papers",
     "same"),
    ("IV.B", "a ray revises log4(N) + 4 spheres at best, 4 log4(N) + 1 at worst",
     "true only of rays that enter one node on each level: they take at most "
     "{column4096_alone_most} tests, where {worst_4096} are allowed. Of the rays that end on a "
     "sphere these are {column4096_alone} % in the most favourable scene, a row of 4096 spheres "
     "that leads away from the eye, and {random4096_alone} % in random4096. All others enter nodes"
     " in vain, since the spheres of neighbouring nodes overlap. So rays enter "
     "{column4096_entered} and {random4096_entered} nodes on {column4096_levels} levels and take "
     "{column4096_tests} and {random4096_tests} tests; {column4096_above} and {random4096_above} %"
     " of them take more than the bound. In the table below, as in the core, all four children of "
     "a node are tested at once",
     "builder/tree/paper.c; rt_first", "numbers",
     "python3 -m lab papers why",
     "refuted"),
    ("IV.B", "sorting by z builds the tree rapidly and optimally",
     "rapidly, but not optimally: neighbours by z need not be neighbours in space. In random4096 a"
     " line through the scene meets {random4096_cover} of the nodes' spheres in the mean, by the "
     "ratio of their discs, and {random4096_cover_space} if each level halves space twice instead."
     " Rays take up to 110 times the visits of the balanced tree ([trees.md](trees.md))",
     "builder/tree/paper.c; rt_first", "numbers",
     "build/sphaera render SCENE --tree paper --counters", "refuted"),
    ("V.B", "16 meridians and parallels find the sphere's pixels; more are more accurate",
     "more are more accurate, but 16 leave out 110 pixels of the sphere at 160x90, and "
     "{outline_hd} at the paper's 1280x720, since rows and columns join the points by steps. Of "
     "{outline_left_out} pixels that are left out by real numbers, {outline_between} lie inside "
     "straight lines through the same points, the others outside of these too. Two points are "
     "needed for each pixel of the radius; 64 leave out {outline_64} at 160x90 "
     "([effects.md](effects.md#the-accurate-method-step-by-step))",
     "builder/background/outline.c; rt_spans", "numbers",
     "make background", "refuted"),
    ("V.B", "3 additions, 5 multiplications, 4 sines and cosines a point",
     "10.7 additions, 9.3 multiplications, 1.2 divisions and, as sines are kept for a row, 2.1 of "
     "these a point; this includes the projection, which the paper leaves out",
     "builder/background/outline.c; -", "count",
     "make background", "other"),
    ("V.C", "X_P1 = X_C + 1.4",
     "without R these are right for spheres of radius 1 alone. The square that the paper draws, of "
     "an edge of 2.8 R, is that of X_C + 1.4 R, which is taken",
     "builder/background/outline.c; rt_background", "text", "make background", "refuted"),
    ("V.C", "2 additions and 2 subtractions for all 4 points",
     "to these come 13 additions, 5 multiplications and 5 divisions to project them",
     "builder/background/outline.c; -", "count",
     "make background",
     "other"),
    ("V.C", "2.8^2 / pi = 2.5 times the pixels of the disc are traced",
     "2.5 times in view `centred`: 5776 pixels for 2302",
     "builder/background/outline.c; rt_background", "count",
     "build/sphaera background scenes/views/centred.nff --size 160x90", "same"),
    ("V.C", "the coefficient 1.4 prevents errors up to 90 degrees",
     "only up to {square_angle} degrees: the line from the eye through C + 1.4 R at v degrees "
     "passes the centre at a distance of 1.4 R cos(v), which is less than R beyond that angle. In "
     "`off_axis` the point is at {square_point} degrees, so {square_beyond} pixels that see the "
     "sphere around everything are outside of the square, and {square_lost} of them lose what they"
     " see ([effects.md](effects.md#the-fast-method))",
     "builder/background/outline.c; rt_background", "numbers",
     "make background", "refuted"),
    ("V.C", "the second method is less disadvantageous, and the hardware uses it",
     "of `centred` it traces 2.5 times the pixels, each of which costs a visit at least, and saves "
     "arithmetic of the CPU alone; and it may lose pixels, as above. Here `rect` is made to lose "
     "none, and `exact` traces just the disc, by additions in the core "
     "([effects.md](effects.md#background-separation))",
     "builder/background/rect.c; rt_cone", "count", "make background", "other"),
    ("Fig. 5 to 8", "the root sphere's pixels: points, rows, columns and border; the square",
     "each step drawn, with the pixels that it leaves out in red "
     "([effects.md](effects.md#the-accurate-method-step-by-step)); Figures 1 to 4, 9 and 13 "
     "explain, and show no result",
     "builder/background/outline.c; rt_spans", "numbers",
     "make background", "same in kind"),
    ("VI.A", "11 multiplications and 11 additions",
     "{paper_mul} and {paper_add}, R^2 being stored",
     "reference/predicates.c; rt_leaf_sums", "count",
     "build/sphaera operations scenes/paper5.nff",
     "same"),
    ("VI.A", "this is the minimum",
     "{machine_mul} and {machine_add} are enough: 3 of the multiplications and 2 of the additions "
     "calculate |VP|^2 for each sphere, where once a ray is enough; here one multiplication more "
     "squares R. If the ray is normalised first, which takes a root and 3 divisions, "
     "{geometric_mul} and {geometric_add} are enough",
     "reference/predicates.c; rt_leaf_sums", "count",
     "build/sphaera operations scenes/paper5.nff", "refuted"),
    ("VI.A", "VC.VP < 0 and R^2 < |VC|^2: no intersection",
     "true: exact integers disagree in {wrong} of {tests} answers. The condition ends a test after"
     " {behind_mul} multiplications",
     "reference/predicates.c; rt_leaf", "bits",
     "build/sphaera operations scenes/views/inside.nff --size 64x36", "same"),
    ("VI", "for inner nodes only whether there is an intersection",
     "[rt_filter](../design/traversal.md#rt_filter), proved never to lose a hit",
     "trace/filter.c; rt_filter", "bits", "make test ONLY=test_filter", "built"),
    ("VI.A", "(R^2 - L^2) |VP|^2 + (VC.VP)^2 > 0",
     "[rt_leaf](../design/primitives.md#rt_leaf): `disc > 0 and (b > 0 or k > 0)`, exact; also the "
     "far root from inside", "prim/sphere.c; rt_leaf", "bits", "make test ONLY=test_leaf", "same"),
    ("VI.A", "t = T - sqrt(T1); Point = V + t VP",
     "root of `disc`, so |VP| is never needed; one division a shaded hit",
     "prim/sphere.c; rt_hit_point", "bits", "make test ONLY=test_core.sh", "built"),
    ("VI.B", "MN = VP - 2 (CM.VP) CM",
     "[rt_reflect](../design/shading.md#rt_reflect): times n.n, without root or division",
     "shade/surface.c; rt_reflect", "bits", "make test ONLY=test_core.sh", "built"),
    ("VI.B", "Col = (1-A) C_F + A C_R",
     "[rt_blend](../design/shading.md#rt_lambert), from front to back",
     "shade/colour.c; rt_blend", "bits", "make test ONLY=test_core.sh", "built"),
    ("VI.B", "a mirrored ray checks all nodes and takes the nearest",
     "so does every ray here; children near first and pruned",
     "trace/traverse.c; rt_traverse", "bits",
     "make test ONLY=test_model",
     "built"),
    ("VI.C", "the light's coefficient is a triple dot product of normal and direction",
     "built as the dot product of two vectors of three components; below, what else it can mean",
     "shade/material.c; rt_cosine", "text",
     "make papers", "not told"),
    ("VI.C", "a shadow ray; normal . light",
     "[rt_lights](../design/shading.md#rt_lights): up to 8 lights, ambient light",
     "shade/colour.c; rt_lights", "bits", "make test ONLY=test_core.sh", "built"),
    ("VI.D", "spheres that intersect: R^2 - |MC|^2 > 0",
     "effect INTERPENETRATE, and [what it mends](../design/model.md#first-hits)",
     "trace/traverse.c; rt_interpenetrate", "bits", "make test ONLY=test_interpenetrate",
     "built"),
    ("Fig. 10", "spheres, a light, two reflections",
     "`scenes/paper5.nff`, of five spheres, below; the paper names no number, and its scene is not "
     "published",
     "render/render.c; rt_engine", "text",
     "make render SCENE=paper5",
     "same in kind"),
    ("Fig. 11", "the small sphere is found first: wrong",
     "{hidden_first} of 57 600 pixels are wrong, below",
     "trace/traverse.c; rt_first", "numbers",
     "make papers", "same"),
    ("Fig. 12", "all intersections are handled correctly",
     "{hidden_mended} wrong pixels are left in the scene of Fig. 11; with a hundred spheres "
     "{paper100_first} are wrong before the correction and {paper100_mended} after, if every "
     "sphere that the mirror ray finds is tested for holding the point",
     "trace/traverse.c; rt_interpenetrate", "numbers",
     "make papers", "same"),
    ("VII", "Rendering, L1, L2 work simultaneously, each makes a frame of its depth",
     "by themselves the three frames of paper100 take {parts_0}, {parts_1} and {parts_2} cycles a "
     "pixel. One engine gives all three in {parts_2}; three engines would take no less time, for "
     "three times the cells. What binds: {bound_parts_0} without reflections, {bound_parts_2} with"
     " two",
     "engine/layers.c; rt_shares", "limit",
     "make papers", "other"),
    ("VII", "1280x720",
     "paper5 takes {hd_paper5}, paper100 {hd_paper100} cycles a pixel of one engine, at 160x90 "
     "from cold caches; frames of 1280x720 a second of that core: {hd_rate} "
     "([accuracy.md](accuracy.md#place-and-route))",
     "render/render.c; rt_engine", "limit",
     "make sim SCENE=paper100 SIZE=160x90 PROFILE=standard "
     "EFFECTS=shadow+reflect2+lights1+inside", "built"),
    ("VII", "a cache holds the primitives used last",
     "of {cold_node_visits} visits of nodes in paper100 {cold_node_misses} fetch a line, of "
     "{cold_leaf_tests} tests of spheres {cold_leaf_misses}, from cold caches",
     "memory/cache.c; rt_cache", "bits",
     "make papers",
     "built"),
    ("VII", "the frames' buffer is an internal FIFO of three frames",
     "three frames of 1280x720 in 24 bits are 8.3 million bytes, which no FPGA of its time holds: "
     "[rt_frames](../reference/rt_top.md) keeps three in external memory, so that the display "
     "never shows half of one, and a queue of lines is what is inside",
     "-; rt_frames", "text", "make top", "other"),
    ("VII", "a frame buffer of three frames, video by HDMI, control by a CPU",
     "[rt_top](../reference/rt_top.md) and [rt_video](../design/video.md), with a driver; every "
     "picture that a display decodes is compared with the model's",
     "engine/layers.c; rt_top", "bits",
     "make top", "built"),
    ("VIII", "no comparison, since no one has used a sphere as a primitive",
     "compared below: meshes of 1280 triangles a sphere have 24 to 31 dB less, at 2200 times the "
     "memory and three to eight times the cycles, on a core of {cells_facet} LUT4eq where spheres "
     "take {cells_sphere}. Their size takes the time, from cold caches: what binds in paper100 is "
     "{bound_paper100_3}, with spheres {bound_paper100_sphere}",
     "trace/traverse.c; rt_facet", "limit",
     "make papers",
     "other"),
]

PARK = [
    ("4", "lod = log2(P_l) - log2(P_b)",
     "built in model and RTL ([textures.md](../design/textures.md#level-of-detail))",
     "texture/lod.c; rt_lod", "bits",
     "make test ONLY=test_levels", "same"),
    ("4", "log2(P_b) in five steps",
     "as printed they have the ratio upside down and the wrong unit, and count the image twice; "
     "here they are corrected ([textures.md](../design/textures.md#p_b-by-build)). Take a wall of "
     "2 by 2 with 256 by 256 texels, at right angles to the ray, at 800x480. By the paper's "
     "definition P_b is where a pixel and a texel have the same area: log2(P_b) is {base_true}. "
     "The printed steps give {base_printed}, where a pixel covers {base_texels} texels; with twice"
     " the texels a side they give {base_printed_512} in place of {base_true_512}, with lengths in"
     " feet {base_printed_feet} in place of {base_true_feet}",
     "scene/texture_base.c; rt_lod", "numbers",
     "build/sphaera build SCENE --lod paper", "refuted"),
    ("4", "the triangle is taken as square to the ray",
     "here too, so the level is off by a fifth at 30 degrees, by one at 60 "
     "([texture_results.md](texture_results.md#every-angle))",
     "scene/texture_base.c; rt_lod", "reference",
     "make textures", "same in kind"),
    ("4", "once in a static scene, each frame where coordinates change",
     "81 of the robot's 370 bases a frame",
     "builder/texture/keep.c; -", "count",
     "build/sphaera build scenes/texture/robot.nff --frames 0..2 -o robot.sph", "same"),
    ("2", "minification by pixel clipping: area, somewhat more blurred where it is thin",
     "P_b is a measure by area, and so is path length; the longer edge is `--levels rays`, of ray "
     "differentials, below. To clip a pixel's outline at a triangle's edges gives another level "
     "only in pixels of an edge, where one ray sees one of both triangles: it is not built",
     "reference/levels.c; -", "text", "-", "not built"),
    ("3", "ray differentials know curved surfaces and cost too much; BMRT estimates by distance",
     "drawn below: BMRT's estimate chooses the levels of path length, and both are off by "
     "{levels_mended} (RMS of linear light), ray differentials by {levels_rays}. Cones of rays are"
     " the same as path length, which is their width",
     "reference/levels.c; rt_path", "reference",
     "make papers", "same in kind"),
    ("5", "log2(P_b) is kept in the triangle cache",
     "here it is in the mapping record, which a textured hit reads anyway, so it costs neither a "
     "read nor a miss. Beside the triangle only 2 of 256 bits are free. In a place of its own it "
     "would take one more read a hit, of which a cache of 16 lines misses {alone_kitchen} of "
     "{hits_kitchen} in our kitchen, and {alone_of_field} % on a ground of 80 000 triangles "
     "(below)",
     "builder/texture/map.c; rt_texture_map", "count",
     "make papers", "other"),
    ("5, Fig. 1", "texture mapping unit, ray stack, triangle and texture cache",
     "[rt_texture](../design/textures.md#rt_texture). Of two rays at a hit one goes on, and the "
     "other waits with its path in a place for each depth "
     "([rt_rays](../design/shading.md#rt_refract)), which is the paper's ray stack; without "
     "refraction no ray waits",
     "texture/lookup.c; rt_texture", "bits",
     "make test ONLY=test_core_texture",
     "built"),
    ("6", "all scenes tend to higher levels",
     "so do ours, with other shares, since these depend on how images lie on surfaces. In the "
     "paper's own scenes ([texture_results.md](texture_results.md#bart-levels)) the shares of the "
     "robot agree, those of the museum nearly",
     "reference/levels.c; rt_lod", "reference",
     "make textures", "same in kind"),
    ("Table I", "61, 60, 1, 2, 1 operations for BMRT's levels",
     "15, 24, 2, 2, 1 for the estimate of section 3; no list of the 61 is given",
     "reference/levels.c; rt_lod", "text",
     "make textures",
     "not told"),
    ("Table I", "1, 0, 0, 0, 1 with P_b kept", "1, 0, 0, 0, 1",
     "builder/texture/keep.c; rt_lod", "count",
     "make textures", "same"),
    ("Table I", "12, 13, 2, 2, 2 with P_b at the hit",
     "9, 9, 1, 1, 2, since the corrected formula is shorter",
     "scene/texture_base.c; -", "count",
     "make textures", "other"),
    ("Table I", "hit rates of 74 to 80 % without, 94 to 99 % with MIP-mapping",
     "51 to 53 %, and 91 to 96 %; in its own scenes 58 to 77 %, and 83 to 96 % "
     "([texture_results.md](texture_results.md#bart-cache)). Here a cache line holds 8 texels; the"
     " paper does not say how many its lines hold",
     "memory/cache.c; rt_cache", "count",
     "make textures", "same in kind"),
    ("Table I", "3.7, 6.3, 6.4 frames a second",
     "in its own scenes, clock for clock, {bart_1} with one pipe, {bart_2} with two, by frames of "
     "the RTL, with all lights and two reflections; the cores that drew them are {bart_clock} "
     "([texture_results.md](texture_results.md#the-texture-papers-own-scenes))",
     "texture/lookup.c; rt_texture", "limit",
     "make bart BART=FOLDER", "other"),
    ("Table I", "MIP-mapping adds 5 to 24 % frames a second",
     "up to 8 % behind an SDRAM, twofold and more with a tenth of its bytes, else nothing",
     "texture/lookup.c; rt_texture", "limit",
     "make textures", "same in kind"),
    ("6", "88 % of the logic cells and 78 % of the memory of a Virtex-5 LX330",
     "our core for its scenes, ten bounces and six lights, mapped for xc7: {park_lut} LUT "
     "({park_lut_of} % of an LX330), {park_ff} FF ({park_ff_of} %), {park_bram} block RAMs of 36 "
     "kbit ({park_bram_of} %), {park_dsp} DSP48 ({park_dsp_of} %); the paper does not say which "
     "part of its machine takes how much",
     "-; rt_core", "text",
     f"make synth TARGET=xc7 EFFECTS={PARK_CORE}",
     "not told"),
    ("6", "up to ten bounces",
     "ten (`--depth 10`, `REFLECT` 10): our kitchen has {kitchen_10_rays} rays a pixel, "
     "{kitchen_2_rays} with two, and takes {kitchen_10} cycles a pixel in place of {kitchen_2}. "
     "Two mirrors that face each other have {mirrors_10_rays} in place of {mirrors_2_rays} rays "
     "and take {mirrors_10} in place of {mirrors_2} cycles",
     "shade/colour.c; rt_shares", "bits",
     "make papers", "built"),
    ("Fig. 2", "aliasing on the kitchen's floor without MIP-mapping",
     "seen, and its error measured",
     "texture/texel.c; rt_texel_filter", "reference",
     "make textures", "same"),
]

AROXA = [
    ("II.A", "100 primitives at 800x600 take 48 million tests",
     "of primary rays alone, and without a tree: 100 times 480 000. With one, paper100 takes "
     "{tests_paper100} tests a ray by the paper's walk, four children of a node at once",
     "trace/traverse.c; rt_leaf", "text", "make papers", "same"),
    ("II.B", "OpenGL ES, shaders, threads of a GPU",
     "none of it is needed where the tracer itself is hardware", "-; rt_core", "text", "-",
     "not built"),
    ("II.A", "reflection, Snell's law; nothing is said of total internal reflection",
     "one root and no division; total reflection is decided exactly and goes the mirror's way "
     "([shading.md](../design/shading.md#refraction))", "shade/refract.c; rt_refract", "bits",
     "make test ONLY=test_refract", "built"),
    ("III.A", "Listing 3.1: recursion, from MAX_RECURSION_DEPTH 1; a ray that misses is black",
     "no recursion: [a second ray waits](../design/shading.md#shares); the thesis's depth 5 is "
     "`--depth 4`; a ray that misses has background colour `b`", "shade/colour.c; rt_rays", "bits",
     "make test ONLY=test_model_optics", "built"),
    ("III.A", "perform_shading, which is not given; Phong 1975 is in its references",
     "Whitted's sum with Phong's highlight "
     "([shading.md](../design/shading.md#shading-by-whitteds-sum))",
     "shade/colour.c; rt_specular", "text", "make test ONLY=test_model_optics", "not told"),
    ("III.A", "one ray a pixel, so edges are jagged",
     "the same; `--samples N` draws a frame N times as wide and high, and each pixel is the mean "
     "of N x N in linear light", "image/picture.c; rt_pixel_scan", "bits",
     "make test ONLY=test_light", "same"),
    ("III.A", "one finger moves the camera along xy, two spread or pinched move it along z",
     "so they do in the [live view](../reference/tool.md#the-live-view)",
     "view/state.c; -", "bits", "make test ONLY=test_view", "same"),
    ("IV.A", "an iPhone, its clock, cores and battery",
     "a phone's processor, its heat and its battery are not ours to measure", "-; rt_core", "text",
     "-", "not built"),
    ("Table 4.1", "two materials",
     "both are built; which sphere of a scenario has which, the thesis does not tell: here they "
     "alternate ([trees.md](trees.md#scenes))", "scene/generate_scenarios.c; rt_shares", "text",
     "make scenarios", "not told"),
    ("II.A", "95 % of the time goes into intersections",
     "in the model {profile_paper100} % of the instructions in paper100, {profile_random4096} % "
     "with 4096 spheres, {profile_lattice64} % in Scenario 1 with a BIH; in the core {busy} % of "
     "the clocks issue a node in paper100. What binds there: {bound_parts_2}; in paper5, of five "
     "spheres, {bound_paper5}",
     "trace/traverse.c; rt_trace", "limit",
     "make papers", "same in kind"),
    ("II.B, III.B", "BIH beside BVH of boxes and kd-tree, in words",
     "counted beside both, and beside nodes of four boxes and four spheres "
     "([trees.md](trees.md#kinds-of-trees)): a BIH is built 20 to 60 times as fast as a kd-tree, "
     "in a sixth to a third of the bytes, for 0.7 to 1.8 times its steps and 2 to 10 times its "
     "tests; of a binary tree of boxes it takes 0.7 to 0.9 times the steps",
     "builder/tree/bih.c; rt_bih", "count",
     "make kinds",
     "built"),
    ("III.B", "Listings 3.2 to 3.5",
     "built, but corrected ([what they get wrong](../design/bih.md#what-the-listings-get-wrong)). "
     "In Scenario 1 with 64 spheres at 40x68 {listing_seen} pixels see a sphere. Listing 3.5, "
     "taken literally, finds another one than brute force does in {listing_printed} pixels, in "
     "{listing_text} with its two branches exchanged, as the text has them; and in {listing_aware}"
     " if also the ray's direction decides which child is near",
     "trace/bih_walk.c; rt_bih_step", "numbers",
     "make test ONLY=test_bih", "refuted"),
    ("III.B", "boxes of primitives instead of their coordinates build 2 or 3 times as fast",
     "cited from the BIH's own authors and not tried there; of a sphere, the thesis's only "
     "primitive, the middle of the box is the centre. Here every primitive is sorted by its box",
     "builder/tree/bih.c; -", "text", "make kinds", "not told"),
    ("Table 4.2", "statistics of three scenarios",
     "Scenario 1 agrees to the last number, the others in kind",
     "builder/tree/bih.c; -", "count",
     "make scenarios", "same"),
    ("Fig. 4.1", "three scenarios", "drawn below; how they are made, says "
     "[trees.md](trees.md#scenes)",
     "scene/generate_scenarios.c; -", "text",
     "make papers", "same in kind"),
    ("Fig. 4.2", "recursion depths 1 to 5", "`scenes/refraction/four.nff`; depth 5 is `--depth 4`",
     "shade/refract.c; rt_refract", "bits",
     "build/sphaera render scenes/refraction/four.nff --depth 4 --depths -o four.png",
     "same in kind"),
    ("Fig. 4.3", "what rays walk through", "the same six pictures",
     "trace/bih_walk.c; rt_bih", "text",
     "make scenarios",
     "same in kind"),
    ("IV.D", "a BIH of one leaf is slower than brute force",
     "here it takes {leaf_64} cycles a pixel in place of {leaf_brute}, since two thirds of the "
     "rays miss the box around all spheres and test none. What binds: {bound_one_leaf}; without a "
     "tree {bound_brute}",
     "trace/bih_walk.c; rt_bih", "limit",
     "make papers", "other"),
    ("Fig. 4.4", "BIH 8 is best in 7 of 9",
     "BIH {best_leaf} is best in {best_of} of 9, but at most {best_by} % better than BIH 1, since "
     "with small leaves other units bind: points and normals of hits in {points_least} to "
     "{points_most} % of the clocks, the set-up of rays for planes in {setup_least} to "
     "{setup_most} %. With BIH 16 exact tests bind as well, in up to {records_most} % "
     "([trees.md](trees.md#figure-44-speed))",
     "trace/bih_walk.c; rt_bih", "limit",
     "make scenarios-rtl", "other"),
    ("Fig. 4.4", "787 to 1495 % more frames than brute force",
     "{gain_least} to {gain_most} times in the RTL, at 40x68 "
     "([trees.md](trees.md#figure-44-speed))",
     "trace/bih_walk.c; rt_bih", "limit",
     "make scenarios-rtl", "same in kind"),
    ("IV.F", "Scenario 2 gains most by a BIH, Scenario 3 least",
     "Scenario 3 gains least with 64, 128 and 256 spheres; Scenario 2 gains most only with 256",
     "trace/bih_walk.c; rt_bih", "limit",
     "make scenarios-rtl",
     "same in kind"),
    ("Fig. 4.4", "brute force: 2.14 frames a second with 128 spheres, 1.87 with 256",
     "in the RTL 256 spheres take 2.4 times the cycles of 128: there are twice as many tests, and "
     "in {brute_none} % of the clocks rays wait for memory, since 257 records do not fit the 128 "
     "lines of the leaf cache. The thesis's two figures contradict its 1495 %: by that figure all "
     "but the tests takes at most {brute_rest} ms, so 256 spheres have at most {brute_most} frames"
     " a second, unless a test takes {brute_less} % less time when there are twice as many",
     "trace/leaf_unit.c; rt_leaf_unit", "limit",
     "make scenarios-rtl", "other"),
    ("Table 4.2", "leaves of 8 save 87.51, 81.85 and 81.02 % of the nodes",
     "{saved_1}, {saved_2} and {saved_3} in Scenarios 1 to 3 "
     "([trees.md](trees.md#nodes-that-larger-leaves-save)); the third has no two spheres at one "
     "place here", "builder/tree/bih.c; -", "count", "make swept", "same in kind"),
    ("III.B, V.B", "a factor of 1.3; more work should be done to understand parameters",
     "1.1 to 2 and none tried: 1.3 is best by the mean of seven scenes, none costs "
     "{fit_none} % ([trees.md](trees.md#the-factor-of-a-box))",
     "builder/tree/bih.c; rt_bih_step", "count", "make swept", "same"),
    ("Fig. 4.5", "150 kB to 6.2 kB; BIH 16 saves 82.5 % of Scenario 2 and 73.99 % of Scenario 1",
     "170 kB to 6.1 kB, 84.8 % and 80.3 %: random places give more optimized nodes, and our "
     "lattice is cut evenly ([trees.md](trees.md#figure-45-memory))",
     "builder/tree/bih.c; -", "count",
     "make scenarios",
     "same in kind"),
    ("III.A", "the tree is built anew for every frame",
     "measured with all spheres of the scenarios moving, including build and upload: a frame takes"
     " {moving_100} million clocks with 100 spheres, {moving_10000} in a BIH with 10 000, and the "
     "CPU waits for the core; frames a second: {moving_rate} "
     "([trees.md](trees.md#everything-moves))",
     "builder/tree/bih.c; rt_run", "limit",
     "make moving",
     "same in kind"),
    ("V.A", "7 to 15 times as fast as brute force", "see Figure 4.4",
     "trace/bih_walk.c; rt_bih", "limit",
     "make scenarios-rtl",
     "same in kind"),
    ("V.A", "good speed needs no heuristic in the build",
     "a tree by the surface-area heuristic draws paper100 {heuristic} times as fast as the best "
     "BIH; visits of nodes bind both ([trees.md](trees.md#beside-the-other-trees))",
     "builder/tree/reinsert.c; rt_traverse", "limit",
     "make scenarios-rtl", "other"),
    ("V.B", "other platforms",
     "hardware that any host may drive ([verification.md](verification.md#the-life-of-a-host))",
     "-; rt_top", "bits",
     "make host", "built"),
    ("V.B", "other primitives", "triangles, planes, cones and cylinders as triangles; parametric "
     "and algebraic surfaces have to be cut into such",
     "prim/facet.c; rt_facet", "bits",
     "make sim SCENE=facets/room", "built"),
    ("V.B", "texture samplers as a cache of the tree", "caches of nodes and leaves",
     "memory/cache.c; rt_cache", "bits",
     "make test ONLY=test_core", "built"),
    ("V.B", "caustics, diffuse inter-reflection",
     "they would take many rays a hit in random directions, which this machine does not have",
     "-; -", "text",
     "-",
     "not built"),
]

PAPERS = {"borodavka": BORODAVKA, "park": PARK, "aroxa": AROXA}


def told():
    """What rows name of clocks, and of frames a second that follow."""
    values = dict(data.read("papers.values")[1])
    core = clocks.key("standard", PARTS_CORE)
    found = {"hd_rate": listed(dict.fromkeys(
        clocks.frames(core, 1280 * 720 * float(values["hd_" + scene])) for scene in PARTS))}
    for pipes in "1", "2":
        found["bart_" + pipes] = listed(rates.column("bart", rates.CLOCK_FOR_CLOCK, pipes=pipes))
    found["bart_clock"] = listed(sorted(set(rates.column("bart", "MHz"))))
    draws = {n: [float(draw) for name, draw in zip(
        rates.column("moving", "scenario, spheres", tree=tree),
        rates.column("moving", "draw, million clocks", tree=tree)) if name.endswith(f", {n}")]
        for n, tree in ((100, "reinserted"), (10000, "BIH"))}
    found["moving_100"] = f"{max(draws[100]):.1f}"
    found["moving_10000"] = f"{min(draws[10000]):.1f} to {max(draws[10000]):.1f}"
    found.update(leaves_told())
    found.update(swept_told())
    decibels = [float(row[1]) for row in data.read("papers.moved")[1]]
    found["moved_least"], found["moved_most"] = (f"{of(decibels):.0f}" for of in (min, max))
    found["moving_rate"] = listed(sorted(set(rates.column("moving", "frames/s, built"))))
    return found


def swept_told():
    """Of `make swept`: what larger leaves save, and a BIH whose nodes never say that their box is
    too large costs."""
    text = Path("docs/results/trees.md").read_text(encoding="utf-8")
    found = {f"saved_{n}": re.search(rf"(?m)^\| S{n} \| ([\d.]+ %) \|", text)[1] for n in (1, 2, 3)}
    fits = re.search(r"(?m)^\| by that of 1.3, mean \|.* ([\d.]+) \|$", text)[1]
    return {**found, "fit_none": f"{100 * float(fits) - 100:.1f}"}


def leaves_told():
    """Of Figure 4.4: which leaves are best, and the least and the most of what binds."""
    head, rows = data.read("trees.bih_cycles")
    times = [[float(cell.split(":")[0]) for cell in row[1:]] for row in rows]
    ways = [name.split()[1] for name in head[1:]]
    times_brute = [float(cell.split(":")[1]) for row in rows for cell in row[1:]]
    best = [ways[row.index(min(row))] for row in times]
    often = max(set(best), key=best.count)
    gains = [100 * (row[0] / min(row) - 1) for row in times]
    head, rows = data.read("trees.bih_limits")

    def parts(name, *columns):
        found = [re.search(rf"(?:^|, ){name} (\d+) %", row[head.index(column)])
                 for row in rows for column in columns]
        return [int(part[1]) if part else 0 for part in found]
    few = [f"BIH {n}" for n in (1, 2, 4)]
    points, setup = parts("points and normals", *few), parts("rays set up for planes", *few)
    records = parts("exact tests", "BIH 16")
    none = parts("none", "brute")
    head, rows = data.read("trees.bih_tree_cycles")
    draws = {row[1]: float(row[2]) for row in rows if row[0] == "paper100"}
    heuristic = min(v for way, v in draws.items() if way.startswith("bih")) / draws["reinserted"]
    return {"heuristic": f"{heuristic:.1f}", "best_leaf": often,
            "best_of": best.count(often), "best_by": f"{max(gains):.0f}",
            "gain_least": f"{min(times_brute):.0f}", "gain_most": f"{max(times_brute):.0f}",
            "points_least": min(points), "points_most": max(points), "setup_least": min(setup),
            "setup_most": max(setup), "records_most": max(records), "brute_none": max(none)}


def listed(words):
    """a, b and c"""
    *first, last = words
    return f"{', '.join(first)} and {last}" if first else last


def table(paper):
    """The rows of a paper as its page shows them. A row has a command, or is not built, and does
    not put its answer off."""
    values = dict(row for table in MEASURED for row in data.read(f"papers.{table}")[1])
    values |= told()
    rows = []
    for place, says, here, where, oracle, command, verdict in PAPERS[paper]:
        what = f"{paper} {place}"
        if verdict not in VERDICTS:
            raise KeyError(f"{what}: the verdict {verdict} is not one of VERDICTS")
        if oracle not in ORACLES:
            raise KeyError(f"{what}: the reason {oracle} is not one of ORACLES")
        if (command == "-") != (verdict == "not built"):
            raise KeyError(f"{what}: what is built, and that alone, has a command")
        for _, figure in by_hand(here):
            raise KeyError(f"{what}: {figure} is told by hand, not by told()")
        if "not measured" in here:
            raise KeyError(f"{what}: it is not measured")
        shown = "-" if command == "-" else f"`{command}`"
        rows.append([place, says, here.format(**values), places(what, where), shown,
                     f"**{verdict}**", oracle])
    return markdown.table(["", "the paper", "here", "model; RTL", "command", "verdict", "by"], rows)


def places(what, where):
    """A row's two files as its page names them; each has to be there."""
    model, module = where.split("; ")
    if model != "-" and not Path("cmodel", model).is_file():
        raise KeyError(f"{what}: there is no cmodel/{model}")
    if module != "-" and not list(Path("rtl").glob(f"*/{module}.v")):
        raise KeyError(f"{what}: there is no {module}.v in rtl")
    return "; ".join(name if name == "-" else f"`{name}`" for name in (model, module))


def verdicts():
    """What the words mean."""
    return markdown.entries([*((f"**{word}**", meaning) for word, meaning in VERDICTS.items()),
                             *((f"by {word}", meaning) for word, meaning in ORACLES.items())])
