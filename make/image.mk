# image.mk - the suite of images: it alone is linked with OpenImageIO
# SPDX-License-Identifier: Apache-2.0

$B/test/test_image: $B/obj/tests/image/test_image.o $(IMAGE) $(LIB)
	$(call say,LD,$(@F))
	@mkdir -p $(@D)
	$(Q)$(CXX) -fopenmp $^ $(IMAGE_LIBS) $(MODEL_LIBS) -o $@

-include $B/obj/tests/image/test_image.d
