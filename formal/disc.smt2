; disc.smt2 - the discriminant of all widths: Lagrange's identity and its bounds, for numbers
; SPDX-License-Identifier: Apache-2.0
; Each lemma is denied, and must then have no solution. Together: docs/results/hard_cases.md.

; ---- k a + b^2 = rad^2 a - |oc x dir|^2, with k = rad^2 - |oc|^2, a = |dir|^2, b = oc.dir ----
(declare-const ox Int) (declare-const oy Int) (declare-const oz Int) (declare-const rad Int)
(declare-const dx Int) (declare-const dy Int) (declare-const dz Int)
(define-fun a () Int (+ (* dx dx) (* dy dy) (* dz dz)))
(define-fun b () Int (+ (* ox dx) (* oy dy) (* oz dz)))
(define-fun k () Int (- (* rad rad) (+ (* ox ox) (* oy oy) (* oz oz))))
(define-fun cx () Int (- (* oy dz) (* oz dy)))
(define-fun cy () Int (- (* oz dx) (* ox dz)))
(define-fun cz () Int (- (* ox dy) (* oy dx)))
(push)
(assert (not (= (+ (* k a) (* b b)) (- (* rad rad a) (+ (* cx cx) (* cy cy) (* cz cz))))))
(set-info :status unsat) (check-sat)
(pop)

; ---- |p x q|^2 <= 8 for p, q in [-1,1]^3: it is convex in each component, so greatest where all
; are -1 or 1. First: m v^2 + n v + c with m >= 0 is at most what it is at one of the ends ----
(declare-const m Real) (declare-const n Real) (declare-const v Real)
(push)
(assert (and (>= m 0.0) (<= (- 1.0) v 1.0)))
(set-info :status sat) (check-sat)
(push)
(assert (> (+ (* m v v) (* n v)) (+ m n)))
(assert (> (+ (* m v v) (* n v)) (- m n)))
(set-info :status unsat) (check-sat)
(pop) (pop)
; the coefficient of v^2 is a sum of squares: with v = px it is (f - v qz)^2 + (v qy - e)^2
(declare-const qy Real) (declare-const qz Real) (declare-const e Real) (declare-const f Real)
(push)
(assert (not (= (+ (* (- f (* v qz)) (- f (* v qz))) (* (- (* v qy) e) (- (* v qy) e)))
                (+ (* (+ (* qy qy) (* qz qz)) v v) (* (- (* (- 2.0) f qz) (* 2.0 e qy)) v)
                   (* f f) (* e e)))))
(set-info :status unsat) (check-sat)
(pop)
; then: at the 64 corners it is at most 8, and 8 at some
(declare-const p1 Int) (declare-const p2 Int) (declare-const p3 Int)
(declare-const q1 Int) (declare-const q2 Int) (declare-const q3 Int)
(define-fun corner ((x Int)) Bool (or (= x 1) (= x (- 1))))
(define-fun sign ((x Int) (y Int)) Int (ite (= x y) 1 (- 1)))      ; x y at a corner
(define-fun sq ((x Int)) Int (ite (= x 0) 0 (ite (or (= x 2) (= x (- 2))) 4 100)))
(define-fun cross2 () Int (+ (sq (- (sign p2 q3) (sign p3 q2))) (sq (- (sign p3 q1) (sign p1 q3)))
                             (sq (- (sign p1 q2) (sign p2 q1)))))
(assert (and (corner p1) (corner p2) (corner p3) (corner q1) (corner q2) (corner q3)))
(push)
(assert (> cross2 8))
(set-info :status unsat) (check-sat)
(pop)
(push)
(assert (= cross2 8))
(set-info :status sat) (check-sat)
(pop)

; ---- so with X = 2^W - 1, D = 2^(WD-1): -8 X^2 D^2 <= disc <= 3 X^2 D^2 ----
; with p = 2^W, q = 2^WD, s = (p - 1)^2 q^2: 8 X^2 D^2 = 2 s, 3 X^2 D^2 = 3/4 s
(declare-const p Int) (declare-const q Int) (declare-const s Int)
(assert (and (>= p 2) (>= q 2)))
(push)
(assert (= s (* (- p 1) (- p 1) q q)))
(assert (not (and (< (* 2 s) (* 2 p p q q)) (< (* 3 s) (* 4 p p q q)))))   ; 2^(DW-1), 2^(DW-2)
(set-info :status unsat) (check-sat)
(pop)
; and 2 s > 2^(DW-2) = p^2 q^2, one bit less does not do, from W = 2 on
(push)
(assert (and (>= p 4) (not (> (* 2 (- p 1) (- p 1)) (* p p)))))
(set-info :status unsat) (check-sat)
(pop)
