# view.mk - the window of `sphaera view`, which the tool has if SDL2 is there
# SPDX-License-Identifier: Apache-2.0
#
#   make view-setup            installs SDL2, and makes the tool
#   make view-time             how soon it answers, and pictures a second: docs/reference/tool.md
# $B/sphaera_view.so is what the tool loads for it: cmodel/view/screen.h.

.PHONY: view-setup view-time
view-setup: movie-setup ## installs SDL2 (apt), for the window of `sphaera view`; makes the tool
	@sh sim/setup.sh libsdl2-dev xvfb
	+$(Q)$(MAKE) --no-print-directory tool

view-time: $(TOOL) ## how soon `sphaera view` answers while the camera moves, at 640x360
	@TMP=$B/view-time SPHAERA=$(TOOL) sh sim/view_time.sh

$(SDL_C:%.c=$B/obj/%.o): override CFLAGS += $(call pkg,--cflags sdl2)

$B/sphaera_view.so: $(call objects,obj/,$(SDL_C)) $B/sources
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) -shared -Wl$(comma)--no-undefined $(filter %.o,$^) \
	    $(call pkg,--libs sdl2))

# The parts that know neither threads nor windows, for their suite.
VIEW_PURE := $(addprefix cmodel/view/,camera.c aim.c keys.c state.c script.c meter.c cell.c pick.c \
             draw.c paint.c)
$B/test/test_view: $(call objects,obj/,$(VIEW_PURE) $(IMAGE_C) $(LAZY_C))
$B/test/test_view.sanitized: $(call objects,asan/obj/,$(VIEW_PURE) $(IMAGE_C) $(LAZY_C))

-include $(patsubst %.o,%.d,$(call objects,obj/,$(SDL_C)) \
                            $(call objects,asan/obj/,$(VIEW_PURE) $(IMAGE_C) $(LAZY_C)))
