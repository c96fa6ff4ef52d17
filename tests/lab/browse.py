# browse.py - a report's page in a real browser: what it shows, and that it moves
# SPDX-License-Identifier: Apache-2.0
"""usage: PYTHONPATH=. python3 tests/lab/browse.py FOLDER KIND=PAGE...
KIND: report, wrong, gallery, film. Prints each kind and what was looked at, below; what is not as
it should be begins with WRONG, and the exit code is 1. FOLDER gets screenshots."""
import subprocess
import sys

from lab.report.browser import Browser

faults = []


def check(what, good):
    print("  " if good else "WRONG", what)
    if not good:
        faults.append(what)


def colourful(path):
    """Not one colour all over: each channel varies."""
    said = subprocess.run(["oiiotool", "--stats", path], capture_output=True, text=True,
                          check=True).stdout
    line = next(line for line in said.splitlines() if "Stats StdDev" in line)
    return all(float(value) > 1 for value in line.split(":")[1].split()[:3])


def visible(browser, selector):
    return browser.value(f"document.querySelector('{selector}')?.getClientRects().length > 0")


def slider(b):
    """Where the edge is, after the pointer has pulled it; after a key."""
    box = b.value("(c => { c.scrollIntoView(); return (r => [r.left, r.top, r.width, r.height])"
                  "(c.getBoundingClientRect()); })(document.querySelector('.compare'))")
    y = box[1] + min(box[3] / 2, 200)
    b.mouse("mousePressed", box[0] + box[2] * .5, y, 1)
    b.mouse("mouseMoved", box[0] + box[2] * .25, y, 1)
    b.mouse("mouseReleased", box[0] + box[2] * .25, y)
    at = b.value("parseFloat(document.querySelector('.compare').style.getPropertyValue('--at'))")
    check(f"the slider follows the pointer to 25 %: {at}", at is not None and abs(at - 25) < .5)
    edge = b.value("document.querySelector('.edge').getBoundingClientRect().left")
    check("... and the edge of the pictures", abs(edge + 1 - box[0] - box[2] * .25) < 2)
    b.value("(s => { s.value = 80; s.dispatchEvent(new Event('input')); })"
            "(document.getElementById('slider'))")
    clip = b.value("getComputedStyle(document.querySelector('.over')).clipPath")
    check(f"... and its own handle: {clip}", "80%" in clip)


def maps(b, wanted):
    check(f"{wanted} maps are painted", b.value("+document.body.dataset.painted") == wanted)
    colours = b.value("""[...document.querySelectorAll('canvas')].map(c => new Set(
        new Uint32Array(c.getContext('2d').getImageData(0, 0, c.width, c.height).data.buffer)).size)
        """)
    check(f"... in more than three colours: {colours}", min(colours) > 3)
    box = b.value("(c => { c.scrollIntoView(); return (r => [r.left + r.width / 2, "
                  "r.top + r.height / 2])(c.getBoundingClientRect()); })"
                  "(document.getElementById('cycles'))")
    b.mouse("mouseMoved", *box)
    told = b.value("document.querySelector('.pixel').textContent")
    check(f"the pixel under the pointer is told: {told}",
          all(word in told for word in ("pixel ", "visits ", "clocks a pixel ", "id ")))


def everywhere(b, path, folder):
    """Wide and narrow, light and dark: nothing is cut off, and something is to be seen."""
    for width, scheme in ((1000, "light"), (400, "light"), (400, "dark")):
        b.resize(width, 900)
        b.ask("Emulation.setEmulatedMedia",
              features=[{"name": "prefers-color-scheme", "value": scheme}])
        picture = f"{folder}/{width}-{scheme}.png"
        b.value("scrollTo(0, 0)")
        b.screenshot(picture)
        check(f"{width} pixels, {scheme}: a picture", colourful(picture))
        over = b.value("document.documentElement.scrollWidth - innerWidth")
        check(f"... that is no wider: {over}", over <= 0)
    dark = b.value("getComputedStyle(document.body).backgroundColor")
    check(f"... dark is dark: {dark}", max(map(int, dark[4:-1].split(","))) < 60)
    check(f"{path} complains of nothing and asks for nothing: {b.complaints}", not b.complaints)


def look(b, kind, path, folder):
    """One page."""
    b.open(path)
    if kind == "film":
        b.value("(s => { s.value = 1; s.dispatchEvent(new Event('input')); })"
                "(document.getElementById('film'))")
        seen = b.value("[...document.querySelectorAll('.film img')].map("
                       "i => i.getClientRects().length)")
        check(f"the slider shows the second frame alone: {seen}", seen == [0, 1])
        check("... and says so", b.value("shown.textContent") == "frame 4")
    if kind in ("report", "wrong"):
        slider(b)
        maps(b, 4)
    if kind == "wrong":
        check("the wrong pixel is marked", visible(b, ".mark"))
        check("its rays are shown", visible(b, ".rays li"))
    if kind == "gallery":
        there = b.value("[...document.images].every(i => i.complete && i.naturalWidth > 0)")
        check("every picture is there", there and b.value(
            "document.images.length === document.querySelectorAll('figure').length"))
    everywhere(b, path, folder)


def main(folder, *pages):
    with Browser() as b:
        for page in pages:
            kind, _, path = page.partition("=")
            print(kind)
            look(b, kind, path, folder)
    sys.exit(bool(faults))


if __name__ == "__main__":
    main(*sys.argv[1:])
