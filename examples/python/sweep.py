"""sweep.py - what widths cost: visits and wrong pixels of a scene in four profiles
SPDX-License-Identifier: Apache-2.0

python3 sweep.py LIBRARY.so SCENE.nff       through ctypes, without any package"""
import ctypes
import sys


class Options(ctypes.Structure):
    """sphaera_build_options"""
    _fields_ = [("size", ctypes.c_size_t), ("profile", ctypes.c_char_p),
                ("accel", ctypes.c_char_p)] + [
                    (name, ctypes.c_int) for name in "width height depth shadow reflect refract "
                    "specular texture".split()]


def main(library, path):
    """A line for each profile; `reference` is what the others are compared with."""
    sphaera = ctypes.CDLL(library)
    sphaera.sphaera_frame_counter.restype = ctypes.c_uint64
    error = ctypes.create_string_buffer(512)
    scene, options = ctypes.c_void_p(), Options()

    def call(name, *words):
        if getattr(sphaera, name)(*words, error):
            sys.exit("sweep: " + error.value.decode())

    call("sphaera_scene_read", path.encode(), ctypes.c_uint32(0), ctypes.byref(scene))
    sphaera.sphaera_build_init(ctypes.byref(options))
    options.width, options.height = 64, 48
    visits, exact = sphaera.sphaera_counter_find(b"node_visits"), None
    for profile in ("reference", "fine", "standard", "draft"):
        machine, frame = ctypes.c_void_p(), ctypes.c_void_p()
        options.profile = profile.encode()
        call("sphaera_build", scene, ctypes.byref(options), ctypes.byref(machine))
        call("sphaera_render", machine, 0, ctypes.byref(frame))
        ids = (ctypes.c_uint32 * (64 * 48))()
        sphaera.sphaera_frame_id(frame, ids)
        exact = exact or list(ids)
        wrong = sum(a != b for a, b in zip(exact, ids))
        print(f"{profile:9} {sphaera.sphaera_frame_counter(frame, visits):8} visits, "
              f"{wrong} pixels see another primitive")
        sphaera.sphaera_frame_free(frame)
        sphaera.sphaera_machine_free(machine)
    sphaera.sphaera_scene_free(scene)


if __name__ == "__main__":
    main(*sys.argv[1:])
