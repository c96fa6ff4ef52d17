; digits.smt2 - digits of rt_isqrt, rt_quotient, rt_divide keep their invariants, for integers
; SPDX-License-Identifier: Apache-2.0
; Each lemma is denied, and must then have no solution; first its premises alone must have one.
; Products of unknowns are unknowns of their own, with what is used of them: so all is linear, and
; holds for every width.

; ---- root: rem = used - root^2 <= 2 root; trial 4 root + 1; two more bits of x ----
(declare-const root Int) (declare-const square Int)    ; root^2
(declare-const rem Int) (declare-const used Int) (declare-const pair Int)
(define-fun rem4 () Int (+ (* 4 rem) pair))
(define-fun fits () Bool (>= rem4 (+ (* 4 root) 1)))
(define-fun digit () Int (ite fits 1 0))
(define-fun root2 () Int (+ (* 2 root) digit))
(define-fun square2 () Int (+ (* 4 square) (* digit (+ (* 4 root) 1))))
(define-fun rem2 () Int (- rem4 (ite fits (+ (* 4 root) 1) 0)))
(push)
(assert (and (>= root 0) (<= 0 rem (* 2 root)) (= used (+ square rem)) (<= 0 pair 3)))
(set-info :status sat) (check-sat)
(push)
(assert (not (and (= (+ (* 4 used) pair) (+ square2 rem2)) (<= 0 rem2 (* 2 root2)))))
(set-info :status unsat) (check-sat)
(pop) (pop)
; square2 is (2 root + digit)^2
(push)
(assert (not (= (* (+ (* 2 root) digit) (+ (* 2 root) digit))
                (+ (* 4 root root) (* digit (+ (* 4 root) 1))))))
(set-info :status unsat) (check-sat)
(pop)
; the end: root^2 <= x < (root + 1)^2, and inexact is rem != 0
(push)
(assert (and (>= root 0) (<= 0 rem (* 2 root)) (= used (+ (* root root) rem))))
(assert (not (and (<= (* root root) used) (< used (* (+ root 1) (+ root 1)))
                  (= (= rem 0) (= (* root root) used)))))
(set-info :status unsat) (check-sat)
(pop)

; ---- quotient: scaled = 2 an mant + rem, 0 <= rem < 2 an ----
(declare-const an Int) (declare-const product Int)     ; an * mant
(declare-const scaled Int)
(define-fun goes () Bool (>= rem an))
(define-fun product2 () Int (+ (* 2 product) (ite goes an 0)))     ; an (2 mant + goes)
(define-fun rest2 () Int (* 2 (- rem (ite goes an 0))))
(push)
(assert (and (> an 0) (<= 0 rem) (< rem (* 2 an)) (= scaled (+ (* 2 product) rem))))
(set-info :status sat) (check-sat)
(push)
(assert (not (and (= (* 2 scaled) (+ (* 2 product2) rest2)) (<= 0 rest2) (< rest2 (* 2 an)))))
(set-info :status unsat) (check-sat)
(pop) (pop)
; an (2 mant + d) = 2 an mant + d an
(declare-const mant Int) (declare-const d Int)
(push)
(assert (not (= (* an (+ (* 2 mant) d)) (+ (* 2 an mant) (* d an)))))
(set-info :status unsat) (check-sat)
(pop)
; a digit d cut off: floors of halves are halves of floors
(push)
(assert (and (> an 0) (<= 0 d 1) (<= 0 rem) (< rem (* 2 an))))
(assert (= (* 2 scaled) (+ (* 4 product) (* 2 (ite (= d 1) an 0)) rem)))   ; mant' = 2 mant + d
(set-info :status sat) (check-sat)
(push)
(assert (not (and (<= (* 2 product) scaled) (< scaled (+ (* 2 product) (* 2 an))))))
(set-info :status unsat) (check-sat)
(pop) (pop)

; ---- quotient rounded up: used = an mant + rem, 0 <= rem < an; one more bit of x ----
(declare-const bit Int)
(define-fun more () Int (+ (* 2 rem) bit))
(define-fun less () Int (ite (>= more an) an 0))
(push)
(assert (and (> an 0) (<= 0 rem) (< rem an) (= used (+ product rem)) (<= 0 bit 1)))
(set-info :status sat) (check-sat)
(push)
(assert (not (and (= (+ (* 2 used) bit) (+ (* 2 product) less (- more less)))
                  (<= 0 (- more less)) (< (- more less) an))))
(set-info :status unsat) (check-sat)
(pop)
; the end: an (key - 1) < used <= an key
(define-fun up () Int (ite (= rem 0) 0 an))
(assert (not (and (< (- (+ product up) an) used) (<= used (+ product up)))))
(set-info :status unsat) (check-sat)
(pop)
