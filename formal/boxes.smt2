; boxes.smt2 - why a box of cmodel/trace/bih.h never rejects what is hit, for integers and reals
; SPDX-License-Identifier: Apache-2.0
; Each lemma is denied, and must then have no solution; first its premises alone must have one.
; Of an axis: x = v mant / 2^shift, y = v q / 2^shift with q in [mant, mant + 2), mant >= 2^16, is
; where plane 0 of the frame lies; f = mant 2^s / 2^shift, g = q 2^s / 2^shift is a step. So
; x <= y <= x (1 + 2^-15), where v is below 0 the other way round, and f <= g < f + 1, for a step
; loses a bit at least. f_box_axis.v shows that at = floor(x), limited, and step = floor(f).
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

; ---- plane 0: enter is not above floor(y), and leave, less 1, not below it ----
(define-fun more ((n Int)) Int (div n 32768))
(define-fun enter ((n Int)) Int (+ n (ite (< n 0) (more n) 0)))
(define-fun leave ((n Int)) Int (+ n 2 (ite (< n 0) 0 (more n))))
(push)
(assert (= at (to_int x)))
(assert (ite (>= x 0.0) (and (<= x y) (<= (* 32768.0 y) (* 32769.0 x)))
                        (and (<= y x) (>= (* 32768.0 y) (* 32769.0 x)))))
(set-info :status sat) (check-sat)
(push)
(assert (not (<= (enter at) (to_int y))))
(set-info :status unsat) (check-sat)
(pop) (push)
(assert (not (<= (to_int y) (- (leave at) 1))))
(set-info :status unsat) (check-sat)
(pop) (pop)

; ---- n steps: not below n step, and below n (step + 2) ----
(declare-const n Int)
(push)
(assert (and (= step (to_int f)) (<= f g) (<= g (+ f 1.0)) (<= 0 n 128)))
(set-info :status sat) (check-sat)
(push)
(assert (not (<= (* (to_real n) (to_real step)) (* (to_real n) g))))
(set-info :status unsat) (check-sat)
(pop) (push)
(assert (not (=> (> n 0) (< (* (to_real n) g) (* (to_real n) (to_real (+ step 2)))))))
(set-info :status unsat) (check-sat)
(pop) (pop)

; ---- plane n: i <= floor(y), k = n step <= n g, j >= floor(y) + 1, m = n (step + 2) > n g ----
(declare-const i Int) (declare-const j Int) (declare-const k Int) (declare-const m Int)
(declare-const ng Real)
(push)
(assert (and (<= i (to_int y)) (>= j (+ (to_int y) 1))))
(assert (and (<= (to_real k) ng) (< ng (to_real m))))
(set-info :status sat) (check-sat)
(push)
(assert (not (<= (+ i k) (to_int (+ y ng)))))
(set-info :status unsat) (check-sat)
(pop) (push)
(assert (not (>= (+ j m) (to_int (+ y ng)))))
(set-info :status unsat) (check-sat)
(pop) (push) ; above 0 of one that is not behind the origin
(assert (not (=> (>= (+ y ng) 0.0) (> (+ j m) 0))))
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
