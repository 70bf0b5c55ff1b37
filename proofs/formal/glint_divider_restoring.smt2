; The whole restoring divider, at every width: the lemma of a row in integers, and the induction over the rows. Every
; query but those named `given` is the negation of what it says, and has no answer; `given` shows that the assumptions
; can be met. run.py asks z3; that the rows of the Verilog do what `row` speaks of is shown on bits, by divider.stage.
; M is 2^Y_W, Y the divisor, 0 < Y < M. After i rows: D is the dividend without its last Q_W - i bits, T those bits, q the
; quotient so far, r the remainder; W = 2^i, P = 2^(Q_W - i - 1). A row takes the bit b, the first of T.
(set-logic ALL)
(declare-const M Int) (declare-const Y Int) (declare-const r Int) (declare-const b Int)
(declare-const D Int) (declare-const T Int) (declare-const q Int) (declare-const W Int) (declare-const P Int)
(declare-const whole Int)
(assert (and (< 0 Y) (< Y M) (<= 0 r) (< r Y) (<= 0 b) (<= b 1)))
(define-fun shifted () Int (+ (* 2 r) b))

(push)  ; ---- the sum of a row, as the Verilog writes it: {shifted, 1} + {1, ~divisor, 1}, Y_W + 2 bits of it
(declare-const carry Int) (declare-const difference Int) (declare-const half Int) (declare-const low Int) (declare-const kept Int)
(assert (and (<= 0 carry) (<= carry 1) (<= 0 difference) (< difference (* 4 M))))
(assert (= (+ difference (* carry 4 M)) (+ (* 2 shifted) 1 (* 2 M) (* 2 (- M 1 Y)) 1)))
(define-fun fits () Bool (< difference (* 2 M)))
(assert (and (= difference (+ (* 2 half) low)) (<= 0 low) (<= low 1)))
(assert (=> (< shifted M) (= kept shifted)))  ; the last Y_W bits of shifted
(define-fun reduced () Int (ite fits half kept))
(echo "given: row") (check-sat)
(push) (assert (not (and (= shifted (+ (ite fits Y 0) reduced)) (<= 0 reduced) (< reduced Y))))
(echo "row: 2 remainder + bit = fits divisor + reduced < divisor") (check-sat) (pop)
(push) (assert (not (= fits (>= shifted Y))))
(echo "row: fits says that the divisor comes off") (check-sat) (pop)
(pop)

(push)  ; ---- from row to row
(declare-const f Int) (declare-const T1 Int)
(assert (and (<= 0 f) (<= f 1) (>= W 1) (>= P 1) (<= 0 q) (< q W)))
(assert (and (= T (+ (* b P) T1)) (<= 0 T1) (< T1 P)))
(assert (= D (+ (* q Y) r)))
(assert (= whole (+ (* D 2 P) T)))
(define-fun bits () Int (+ (* T W) q))       ; the register that holds both
(define-fun r1 () Int (- shifted (ite (= f 1) Y 0)))
(define-fun q1 () Int (+ (* 2 q) f))
(define-fun D1 () Int (+ (* 2 D) b))
(echo "given: rows") (check-sat)
(push) (assert (not (= D1 (+ (* q1 Y) r1))))
(echo "rows: the dividend so far is quotient divisor + remainder") (check-sat) (pop)
(push) (assert (not (= whole (+ (* D1 P) T1))))
(echo "rows: with its other bits it is the dividend") (check-sat) (pop)
(push) (assert (not (and (<= 0 q1) (< q1 (* 2 W)))))
(echo "rows: the quotient so far has a bit a row") (check-sat) (pop)
(push) (assert (not (and (=> (= b 0) (< bits (* P W))) (=> (= b 1) (and (<= (* P W) bits) (< bits (* 2 P W)))))))
(echo "rows: the first bit of the register is the next one of the dividend") (check-sat) (pop)
(push) (assert (not (= (+ (- (* 2 bits) (* b 2 P W)) f) (+ (* T1 2 W) q1))))
(echo "rows: shifted by a row, it holds the other bits and the quotient") (check-sat) (pop)
(pop)

(push)  ; ---- the first row begins with D the head, T the other bits, q = 0, W = 1; after the last T is 0, P W is 2^Q_W
(declare-const head Int)
(assert (and (>= P 1) (<= 0 head) (< head Y) (<= 0 T) (< T (* 2 P)) (= whole (+ (* head 2 P) T))))
(echo "given: first") (check-sat)
(push) (assert (not (and (= head (+ (* 0 Y) head)) (= T (+ (* T 1) 0)))))
(echo "first: the books hold") (check-sat) (pop)
(pop)
(push)
(assert (and (= D (+ (* q Y) r)) (= whole (+ (* D 1) 0))))
(echo "given: last") (check-sat)
(push) (assert (not (= whole (+ (* q Y) r))))
(echo "last: dividend = quotient divisor + remainder") (check-sat) (pop)
(pop)
