; boxes.smt2 - why a box of cmodel/trace/bih.h never rejects what is hit, for integers and reals
; SPDX-License-Identifier: Apache-2.0
; Each lemma is denied, and must then have no solution; first its premises alone must have one.
; Of an axis: x = v mant / 2^shift, y = v q / 2^shift with q in [mant, mant + 2), mant >= 2^16, is
; where plane 0 of the frame lies; f = mant 2^s / 2^shift, g = q 2^s / 2^shift is a step, times
; 2^fine. So x <= y <= x (1 + 2^-15), where v is below 0 the other way round, and f <= g < f + 1,
; for a step loses a bit at least. f_box_axis.v shows that at = floor(x), limited, step = floor(f).
(declare-const x Real) (declare-const y Real) (declare-const f Real) (declare-const g Real)
(declare-const at Int) (declare-const step Int)

; ---- what is said of q: 2 |v| <= |v| mant 2^-15, and 2 2^s / 2^shift <= 1 ----
(declare-const v Real) (declare-const mant Real)
(push)
(assert (and (>= mant 65536.0) (>= v 0.0)))
(set-info :status sat) (check-sat)
(push)
(assert (not (<= (* 2.0 v 32768.0) (* v mant))))
(set-info :status unsat) (check-sat)
(pop) (pop)

; ---- plane 0: enter is not above floor(y), and at + 1, and its rest, not below it ----
(define-fun more ((n Int)) Int (div n 32768))
(define-fun enter ((n Int)) Int (+ n (ite (< n 0) (more n) 0)))
(define-fun most ((n Int)) Int (+ n 1 (ite (< n 0) 0 (more n))))
(push)
(assert (= at (to_int x)))
(assert (ite (>= x 0.0) (and (<= x y) (<= (* 32768.0 y) (* 32769.0 x)))
                        (and (<= y x) (>= (* 32768.0 y) (* 32769.0 x)))))
(set-info :status sat) (check-sat)
(push)
(assert (not (<= (enter at) (to_int y))))
(set-info :status unsat) (check-sat)
(pop) (push)
(assert (not (<= (to_int y) (most at))))
(set-info :status unsat) (check-sat)
(pop) (pop)

; ---- n steps, times 2^fine: at least n step, at most n (step + 2) ----
(declare-const n Int)
(push)
(assert (and (= step (to_int f)) (<= f g) (<= g (+ f 1.0)) (<= 0 n 127)))
(set-info :status sat) (check-sat)
(push)
(assert (not (<= (* (to_real n) (to_real step)) (* (to_real n) g))))
(set-info :status unsat) (check-sat)
(pop) (push)
(assert (not (<= (* (to_real n) g) (* (to_real n) (to_real (+ step 2))))))
(set-info :status unsat) (check-sat)
(pop) (pop)

; ---- a step of 2^fine T-words, fine 0 or 4: floor(g) is at most (step >> fine) + 1 ----
(push)
(assert (and (= step (to_int f)) (<= f g) (<= g (+ f 1.0)) (<= 0 step 131071)))
(set-info :status sat) (check-sat)
(push)
(assert (not (and (<= (to_int g) (+ step 1)) (<= (to_int (/ g 16.0)) (+ (div step 16) 1)))))
(set-info :status unsat) (check-sat)
(pop) (pop)

; ---- plane n, enter + i for i <= n steps ng: not above it; plane n + 1, whose last step is of ----
; floor h at most j, leave = most + j + 3 with k >= floor(ng): above it, and above 0 if it is ahead
(declare-const i Int) (declare-const j Int) (declare-const k Int) (declare-const m Int)
(declare-const ng Real) (declare-const h Real)
(push)
(assert (and (<= m (to_int y)) (<= (to_real i) ng)))
(set-info :status sat) (check-sat)
(push)
(assert (not (<= (+ m i) (to_int (+ y ng)))))
(set-info :status unsat) (check-sat)
(pop) (pop) (push)
(assert (and (>= m (to_int y)) (>= j (to_int h)) (>= k (to_int ng))))
(set-info :status sat) (check-sat)
(push)
(assert (not (> (+ m j k 3) (to_int (+ y ng h)))))
(set-info :status unsat) (check-sat)
(pop) (push)
(assert (not (=> (>= (+ y ng h) 0.0) (> (+ m j k 3) 0))))
(set-info :status unsat) (check-sat)
(pop) (pop)

; ---- where at was limited the plane is above all T-words, or behind the origin for any n ----
(push)
(assert (and (= step (to_int f)) (<= 0 n 127) (<= 0 step 131071)))
(set-info :status sat) (check-sat)
(push)
(assert (not (< (+ (enter (- 16777216)) (* n step)) 0)))
(set-info :status unsat) (check-sat)
(pop) (pop)
