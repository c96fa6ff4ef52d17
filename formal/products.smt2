; products.smt2 - what proofs that take products as a function use of them, for integers
; SPDX-License-Identifier: Apache-2.0
; Each lemma is denied, and must then have no solution; first its premises alone must have one.

; ---- a plane that a ray leaves by: (v + u) (g + 2) = v g + 2 (v + u) + u g, where u is 0 or 1 ----
(declare-const v Int) (declare-const u Int) (declare-const g Int)
(push)
(assert (<= 0 u 1))
(set-info :status sat) (check-sat)
(push)
(assert (not (= (* (+ v u) (+ g 2)) (+ (* v g) (* 2 (+ v u)) (ite (= u 1) g 0)))))
(set-info :status unsat) (check-sat)
(pop) (pop)

; ---- the frame of a box: (v - s) g = v g - s g, for v without its sign ----
(declare-const w Int)
(push)
(assert (not (= (* (- v w) g) (- (* v g) (* w g)))))
(set-info :status unsat) (check-sat)
(pop)

; ---- no product is longer than that of the longest factors ----
(declare-const x Int) (declare-const y Int) (declare-const m Int) (declare-const n Int)
(push)
(assert (and (<= (- m) x m) (<= (- n) y n)))
(set-info :status sat) (check-sat)
(push)
(assert (not (and (<= (* x y) (* m n)) (>= (* x y) (- (* m n))))))
(set-info :status unsat) (check-sat)
(pop) (pop)

; ---- a product is the sum of those of its factors' chunks: of high ones and the rest ----
(declare-const s Int)
(push)
(assert (not (= (* (+ (* x s) m) (+ (* y s) n)) (+ (* s s x y) (* s (+ (* x n) (* m y))) (* m n)))))
(set-info :status unsat) (check-sat)
(pop)

; ---- the node filter: (2 r - q) (2 r + q) = 4 r^2 - q^2, of 33 bits for r of 14 bits, q of 16 ----
(declare-const r Int) (declare-const q Int)
(push)
(assert (and (<= 0 r 16383) (<= 0 q 65535)))
(set-info :status sat) (check-sat)
(push)
(assert (not (= (* (- (* 2 r) q) (+ (* 2 r) q)) (- (* 4 r r) (* q q)))))
(set-info :status unsat) (check-sat)
(pop) (push)
(assert (not (< (- 4294967296) (- (* 4 r r) (* q q)) 4294967296)))
(set-info :status unsat) (check-sat)
(pop) (pop)
