# view.mk - what one looks at: the window of `sphaera view`, films, pages
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

# ---- a moving scene as a film: a job for each frame, of this machine or a cluster ----
#   make film SCENE=moving/orbit FRAMES=0..99 MOVIE=orbit.mp4 [ENGINE=slurm]
# $B/film/DIGEST/ keeps the frames, N.png, so that what was interrupted goes on.

FILM_OF  := cmodel/**/*.[ch],cmodel/**/*.cpp,cmodel/machine/*.def
film_plan = $(call values,SCENE FRAMES BUILD_OPTIONS SEED) BUILD=$B sh sim/film.sh
ifeq ($(ENGINE),slurm)
film_jobs = python3 -m lab target-plan film $B $$film/results $$film/jobs '$(FILM_OF)' \
                $$(cat $$film/frames) && $(call jobs_run,$$film/jobs)
else
film_jobs = $(MAKE) --no-print-directory $$(cat $$film/frames)
endif

.PHONY: film
film: $(TOOL) ## SCENE, FRAMES A..B of it, as MOVIE, by the golden model
	$(if $(MOVIE),,@echo "film: MOVIE names no file: make film MOVIE=x.mp4" >&2; exit 1)
	+$(Q)film=$$($(film_plan)) && $(film_jobs) && $(TOOL) movie -o $(call quoted,$(MOVIE)) \
	    $$(cat $$film/frames)

# A frame counts as long as tool and options are the same.
$B/film/%.png: $(TOOL)
	$(call say,FRAME,$(*F))
	$(Q)$(TOOL) render "$$(cat $(@D)/scene)" $$(cat $(@D)/options) --at $(*F) -o $@ \
	    >$(@:.png=.log)

# ---- pages to look at: lab/report makes them, tests/lab/test_report.sh looks ----
#   $B/gallery.html   all scenes of scenes/, one file; $B/gallery/ has what it is made of
GALLERY_SIZE := 256x144
GALLERY      := $(patsubst scenes/%.nff,$B/gallery/%.json,$(sort $(wildcard scenes/*.nff \
                    scenes/*/*.nff)))

.PHONY: gallery browser-setup
gallery: $B/gallery.html ## all scenes of scenes/ as the model draws them, on one page
	@echo "gallery in $<"

$B/gallery.html: $(GALLERY) $(wildcard lab/report/*)
	$(call say,PAGE,gallery.html)
	$(Q)python3 -m lab gallery $B/gallery $@

$B/gallery/%.json: scenes/%.nff $(TOOL)
	$(call say,DRAW,$*)
	@mkdir -p $(@D)
	$(Q)$(TOOL) render $< --size $(GALLERY_SIZE) --samples 2 -o $(@:.json=.png) --json $@ \
	    >$(@:.json=.log) 2>&1 || { cat $(@:.json=.log); exit 1; }

browser-setup: ## installs Chromium (apt), in which tests look at pages
	@sh sim/setup.sh chromium
