// page.js - slider, maps of pixels, the pixel under the pointer
// SPDX-License-Identifier: Apache-2.0
"use strict";

// ---- model | RTL ----
const compare = document.querySelector(".compare");
if (compare) {
    const slider = document.getElementById("slider");
    const show = at => compare.style.setProperty("--at", at + "%");
    slider.addEventListener("input", () => show(slider.value));
    const drag = event => {
        const box = compare.getBoundingClientRect();
        slider.value = Math.max(0, Math.min(100, 100 * (event.clientX - box.left) / box.width));
        show(slider.value);
    };
    compare.addEventListener("pointerdown", event => {
        compare.setPointerCapture(event.pointerId);
        drag(event);
    });
    compare.addEventListener("pointermove", event => event.buttons & 1 && drag(event));
}

// ---- frames of a moving scene ----
const film = document.getElementById("film");
if (film) film.addEventListener("input", () => {
    document.querySelectorAll(".film img").forEach((picture, at) => {
        picture.hidden = at !== +film.value;
        if (!picture.hidden) document.getElementById("shown").textContent = picture.alt;
    });
});

// ---- maps ----
const RAMP = ["000004", "1b0c41", "4a0c6b", "781c6d", "a52c60", "cf4446", "ed6925", "fb9b06",
    "f7d13d", "fcffa4"].map(c => [0, 2, 4].map(i => parseInt(c.slice(i, i + 2), 16)));

function colour(t) {
    const at = Math.min(t, 1) * (RAMP.length - 1), i = Math.min(Math.floor(at), RAMP.length - 2);
    return RAMP[i].map((low, k) => low + (RAMP[i + 1][k] - low) * (at - i));
}

// Words of 32 bits, deflated, in base64.
async function words(text) {
    const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint32Array(await new Response(stream).arrayBuffer());
}

const format = value => value.toLocaleString("en", { maximumFractionDigits: 1 })
    .replaceAll(",", "\u202f");

function paint(plane) {
    const canvas = document.getElementById(plane.name), context = canvas.getContext("2d");
    const picture = context.createImageData(canvas.width, canvas.height);
    const top = plane.values.reduce((a, b) => Math.max(a, b), 1) / plane.per;
    const height = plane.log ? value => Math.log1p(value) / Math.log1p(top) : value => value / top;
    plane.values.forEach((word, i) => {
        if (!word) return;  // not drawn, or not traced
        const [r, g, b] = colour(height(word / plane.per));
        picture.data.set([r, g, b, 255], 4 * i);
    });
    context.putImageData(picture, 0, 0);
    const scale = canvas.closest("figure").querySelector(".scale");
    const middle = plane.log ? Math.expm1(Math.log1p(top) / 2) : top / 2;
    scale.innerHTML = "0<i></i>" + format(middle) + "<i></i>" + format(top) + " " + plane.unit;
    scale.querySelectorAll("i").forEach((bar, half) => {
        const stops = [0, .25, .5, .75, 1].map(t => colour((half + t) / 2).map(Math.round));
        bar.style.background = `linear-gradient(90deg, ${stops.map(c => `rgb(${c})`)})`;
    });
}

async function maps() {
    const planes = JSON.parse(document.getElementById("planes").textContent);
    for (const plane of planes) {
        plane.values = await words(plane.data);
        if (plane.map) paint(plane);
    }
    const line = document.querySelector(".pixel");
    const point = event => {
        const box = event.currentTarget.getBoundingClientRect(), p = planes[0];
        const x = Math.floor((event.clientX - box.left) / box.width * p.width);
        const y = Math.floor((event.clientY - box.top) / box.height * p.height);
        if (x < 0 || y < 0 || x >= p.width || y >= p.height) return;
        const told = planes.map(plane => {
            const value = plane.values[y * p.width + x];
            return plane.names && value in plane.names ? plane.names[value]
                : `${plane.title} ${format(value / plane.per)}`;
        });
        line.textContent = [`pixel ${x}, ${y}`, ...told].join(" \u00b7 ");
    };
    for (const map of document.querySelectorAll("canvas, .compare"))
        map.addEventListener("pointermove", point);
    document.body.dataset.painted = planes.filter(plane => plane.map).length;
}
if (document.getElementById("planes")) maps();

// ---- commands ----
for (const button of document.querySelectorAll("button[data-copies]"))
    button.addEventListener("click", async () => {
        const text = document.getElementById(button.dataset.copies).textContent;
        await navigator.clipboard.writeText(text);
        button.textContent = "copied";
    });
