# image.mk - the suite of images: it alone is linked with OpenImageIO
# SPDX-License-Identifier: Apache-2.0

$B/test/test_image: $B/obj/tests/image/test_image.o $(IMAGE) $(LIB)
	$(call say,LD,$(@F))
	@mkdir -p $(@D)
	$(call make_whole,$(CXX) $^ $(IMAGE_LIBS) $(MODEL_LIBS))

-include $B/obj/tests/image/test_image.d
