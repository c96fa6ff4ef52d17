/* sanitized.h - whether this program runs under sanitizers, which slow it down about tenfold
 * SPDX-License-Identifier: Apache-2.0
 *
 * They look for other mistakes than wrong numbers: a share of the cases does for them.
 */
#ifndef SPH_TEST_SANITIZED_H
#define SPH_TEST_SANITIZED_H

#ifdef __SANITIZE_ADDRESS__
enum { SANITIZED = 1 };
#else
enum { SANITIZED = 0 };
#endif

#endif
