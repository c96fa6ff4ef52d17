# hard.mk - hard cases: the program `hard`, its objects, `make hard`
# SPDX-License-Identifier: Apache-2.0
#
#   make hard                  all operands of three bits, 1 million generated cases a profile
#   make hard N=175000000 STATE=file      a campaign that can be stopped and resumed
#   make hard FAMILY=facets               one family, or those of a kind
#   make hard ENGINE=slurm                on a cluster: docs/guide/simulation.md
HARD_C      := $(sort $(wildcard tests/hard/*.c))
HARD_CFLAGS := -Itests -Itests/hard -ffp-contract=off
HARD_LIBS    = $(call pkg,--libs jansson) $(MODEL_LIBS)

HARD      := $B/hard
hard_plan  = --cases $(N) --seed $(SEED) $(if $(FAMILY),--family $(FAMILY) --exhaustive 0)
hard_state = $(if $(filter slurm,$(ENGINE)),$(HARD)/state,$(STATE))
hard_run   = $< $(hard_plan) --processes $(JOBS) $(if $(hard_state),--state $(hard_state)) \
                 --json $B/test/hard.json
# Of a cluster: parts, whose state files are put together.
hard_parts = $(if $(filter slurm,$(ENGINE)), \
    python3 -m lab hard-campaign plan $< $(HARD)/results $(HARD)/jobs -- $(hard_plan) && \
    $(call jobs_run,$(HARD)/jobs) && \
    python3 -m lab hard-campaign merge $< $(HARD)/results $(HARD)/state -- $(hard_plan))

hard: $B/test/hard ## hard cases: N a profile, SEED, JOBS processes, STATE file to resume from
	$(Q)$(hard_parts)
	@$(hard_run)

# Of a campaign that is done, at once. Families that it leaves out keep the rows that they have.
hard-page: $B/test/hard ## the same, and its table and chart put into docs/results/hard_cases.md
	$(Q)$(hard_parts)
	@$(hard_run) >$B/test/hard.table
	@$< --list >$B/test/hard.list
	@python3 -m lab hard-page docs/results/hard_cases.md "make hard-page N=$(N)" '$(FAMILY)' \
	    docs/pictures/hard_cases.svg $B/test/hard.list $B/test/hard.table

hard-lists: $B/test/hard ## prints the named cases, their families, and which notices which fault
	@$< --list
	@python3 -m lab faults table --by hard,test,case

.PHONY: hard hard-page hard-lists hard-pictures
$B/test/obj/%.o: %.c $B/flags
	$(call progress,CC,$(<F))
	@mkdir -p $(@D)
	$(call compile_whole,$(CC) $(CFLAGS) $(HARD_CFLAGS))

$B/test/hard: $(HARD_C:%.c=$B/test/obj/%.o) $B/obj/cmodel/tool/progress.o $(MODEL)
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) $^ $(HARD_LIBS))

# For benches of the RTL (tb/hard.h): what they do not call is not linked.
$B/test/libhard.a: $(patsubst %.c,$B/test/obj/%.o,$(filter-out %/main.c %/report.c \
                     %/campaign.c,$(HARD_C)))

$B/test/asan/%.o: %.c $B/flags
	$(call progress,CC,"$(<F) sanitized")
	@mkdir -p $(@D)
	$(call compile_whole,$(CC) $(CFLAGS) $(HARD_CFLAGS) $(SANITIZE))

$B/test/hard.sanitized: $(HARD_C:%.c=$B/test/asan/%.o) $B/asan/obj/cmodel/tool/progress.o \
                        $B/asan/libsphaera.a
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) $(SANITIZE) $^ $(HARD_LIBS))

# Close-ups of what floats get wrong, and their counts, into docs/results/hard_cases.md.
PICTURES_C := $(sort $(wildcard tests/hard/pictures/*.c))
hard-pictures: $B/test/hard-pictures ## pictures and counts of docs/results/hard_cases.md
	@$< tests/hard/pictures docs/pictures >$B/test/hard.counts && cat $B/test/hard.counts
	@python3 -m lab place docs/results/hard_cases.md "make hard-pictures" counts \
	    $B/test/hard.counts

$B/test/hard-pictures: $(PICTURES_C:%.c=$B/test/obj/%.o) $B/test/libhard.a $(IMAGE) $(MODEL)
	$(call say,LD,$(@F))
	$(call make_whole,$(CXX) $^ $(IMAGE_LIBS) $(MODEL_LIBS))

# the suite runs all three
tests/hard/test_hard.sh: | $B/test/hard $B/test/hard.sanitized $B/test/hard-pictures
tests/flow/test_benches.sh: | $B/test/libhard.a

-include $(HARD_C:%.c=$B/test/obj/%.d) $(PICTURES_C:%.c=$B/test/obj/%.d) \
         $(HARD_C:%.c=$B/test/asan/%.d)
