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

; ---- quotient rounded up, 17 bits a round: rest < 2^18 by, of it an estimate q ----
; size: 2^(length of by); t = floor(8 rest / size); y, u21: by y = 2^20 size (1 - 41/2^24 .. 1)
; (reciprocal.c); q = floor(t y / 2^23), but for a product of 3 bits by 3
(declare-const rest Int) (declare-const by Int) (declare-const size Int)
(declare-const tsize Int) (declare-const tyby Int) (declare-const qby Int)    ; products
(define-fun two23 () Int 8388608)
(push)
(assert (and (> by 0) (< by size) (<= size (* 2 by)) (<= 0 rest) (< rest (* 262144 by))))
(assert (and (<= tsize (* 8 rest)) (< (* 8 rest) (+ tsize size)) (<= 0 tsize)))
(assert (and (<= tyby (* 1048576 tsize)) (>= (* 16 tyby) (* (- 16777216 41) tsize))))
(assert (and (<= (* two23 qby) tyby) (< tyby (+ (* two23 qby) (* two23 by) (* 49 by)))))
(set-info :status sat) (check-sat)
(push)
(assert (not (and (<= qby rest) (< rest (+ qby (* 2 by))))))
(set-info :status unsat) (check-sat)
(pop) (pop)
; the end: by (key - 1) < used <= by key, with what is left below 2 by
(push)
(assert (and (> by 0) (<= 0 rest) (< rest (* 2 by)) (= used (+ product rest))))
(set-info :status sat) (check-sat)
(define-fun up () Int (ite (= rest 0) 0 (ite (<= rest by) by (* 2 by))))
(assert (not (and (< (- (+ product up) by) used) (<= used (+ product up)))))
(set-info :status unsat) (check-sat)
(pop)
