# film.mk - a moving scene as a film: a job for each frame, of this machine or a cluster
# SPDX-License-Identifier: Apache-2.0
#
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
