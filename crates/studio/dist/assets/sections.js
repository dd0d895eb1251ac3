var e={"theory/loads#force-and-couple":`## Force and couple

Each part contributes the negative of its mass times the acceleration of its centre. With F_p the force of part p in the plane z_p

\`\`\`formula
F = SUM over p of F_p        M_x + i M_y = i SUM over p of (z_p − z_ref) F_p    (5.1)
\`\`\`

*Source: Newton's law and the moment of forces.*

| part | force in its plane |
|---|---|
| reciprocating mass | −m_rec s̈ e^{ib} |
| big end of a rod | Ω² m_A r e^{i(pin angle)}, in the plane of its cylinder |
| unbalance of the throw | Ω² U e^{i(pin angle)}, in the plane of the throw |
| counterweight | Ω² U e^{i(its angle)} |
| balance shaft weight | (ratio · ω)² U e^{i(ratio · θ + phase)} |

Ω is the speed of the crankshaft that carries the part.

![Forces in their planes from the side, roll moment and torque from the free end](../images/theory/planes.svg)

*Above, from the side: first-order forces of an in-line three at θ = 20° in their planes, with the lever of (5.1). Below, from the free end: M_z on the block, T into the driveline, and a force of a balance shaft with one of the levers of (5.6).*`,"theory/loads#roll-moment":`## Roll moment

Take all moving parts as one system, with L their angular momentum about the reference axis parallel to z. Two moments act on it: the block's, which
is the negative of the roll moment M_z that we look for, and the driveline's at the end of crankshaft 1, which is the
negative of the delivered torque T:

\`\`\`formula
dL/dt = −M_z − T        M_z = −T − dL/dt                                        (5.2)
\`\`\`

*Source: the balance of moment of momentum.*

T follows from the kinetic energy E alone, since at constant speed nothing else takes power (gas is off, and there is no friction):

\`\`\`formula
T ω = −dE/dt                                                                    (5.3)
\`\`\`

*Source: the balance of energy.*

A mass that moves along u on the line v_j (the piston on the cylinder axis, the rod's small end on the line of the piston pin) has E = ½ m_j ṡ² and the angular
momentum of a point at s + i v_j about the crankshaft's axis, L = −m_j v_j ṡ. Therefore, with m = Σ m_j and n the ratio of the crankshaft to crankshaft 1,

\`\`\`formula
T   = −n m Ω² s′ s″                                                             (5.4)
M_z = −T + Ω² s″ SUM over j of m_j v_j                                          (5.5)
\`\`\`

*Derived here from (5.2) and (5.3).*

The last term is the moment of the inertia forces −m_j s̈ about the axis, with the levers v_j. The first is the reaction to the
torque: it is what the side thrust of the piston does to the cylinder wall. Rotating masses on an axis at
constant speed have constant L and E: they add nothing about their own axis. Off the reference point each force adds its lever:

\`\`\`formula
M_z(about ref) = M_z(about its axis) + (x − x_ref) F_y − (y − y_ref) F_x        (5.6)
\`\`\`

*Derived here from the moment of a force.*

which is how a balance shaft whose axis is off the crank's gives a roll moment.

![Roll moment of a twin by part over the crank angle](../images/theory/roll-moment.svg)

*Roll moment of the parallel twin \`examples/real/twin-270.toml\` by part (\`lanchester report examples/real/twin-270.toml\`): shafts off the axis of the crank give most of it, by (5.6).*

Other definitions are in use. [Louvigny2008] counts in M_z the forces of the balance shafts alone, without the torque reaction and
side thrust. That quantity is kept under its own name in the validation tables; it is not the roll moment.`,"theory/orders":`# Order coefficients

The inertia force of a reciprocating mass needs the piston's acceleration by order:

\`\`\`formula
−s″ / r = SUM over n ≥ 1 of  Re( c_n e^{inφ} )                                  (3.1)
\`\`\`

For a centred cylinder all \`c_n\` are real, c_1 = 1, the even ones are the A2, A4, A6 of the literature, and the
other odd ones vanish. With an offset they are complex and every order is there.`,"theory/spectrum":`# The two-sided spectrum

Every periodic force in the plane across the crank is a sum of vectors that turn:

\`\`\`formula
F(θ) = F_x + i F_y = SUM over n of  f_n e^{inθ}        n = …, −2, −1, 0, 1, 2, …  (4.1)
\`\`\`

*Source: a Fourier series with complex coefficients.*

n > 0 turns with the crank, n < 0 against it; f_0 is constant. The couple M_x + i M_y has such a spectrum of its own.
A usual one-sided spectrum of F_x and F_y has the same numbers, but hides what matters for balancing: the sense.`,"theory/spectrum#one-order-is-an-ellipse":`## One order is an ellipse

Over one turn the vector f_n e^{inθ} + f_−n e^{−inθ} draws an ellipse with

\`\`\`formula
major half axis               |f_n| + |f_−n|
minor half axis               | |f_n| − |f_−n| |
direction of the major axis   ½ (arg f_n + arg f_−n)                            (4.2)
\`\`\`

*Derived here from the longest and the shortest sum of two vectors that turn against each other.*

A force along one line is half forward and half backward. A circle is one of them alone.

![Forward and backward vector and the ellipse of their sum](../images/theory/ellipse.svg)

*One order: f_n turns with the crank, f_−n against it, and their sum draws the ellipse of (4.2).*`,"theory/spectrum#star-diagrams":`## Star diagrams

By (4.3) the sum over equal cylinders is a sum of unit vectors: one star for each order and sense. Its
resultant times ½ m r ω² |c_n| is the order's force; the stars with the vectors weighted by z give the couple.
Where a star closes, that order and sense is balanced whatever the masses.

![Stars of the first order couple of an in-line three](../images/theory/couple-stars.svg)

*First-order couples of the in-line three \`examples/in-line-3.toml\` as stars, forward and backward, each vector weighted by its z; the broad arrow is the sum. Weights and shafts are left out. Cylinder 2 stands in the reference plane and has no arrow.*`,"theory/firing":`# Firing

A cylinder can fire where its piston is at TDC. With τ_j the θ of the TDC of cylinder j, a four-stroke engine of one crankshaft
leaves two possible firing angles for it in the cycle, a two-stroke engine one:

\`\`\`formula
firing angle of j  ∈  { τ_j + 2π k }        k = 0, 1 (four-stroke), k = 0 (two-stroke)   (9.1)
\`\`\`

*Derived here from what a dead centre is.*

counted from the firing TDC of cylinder 1. On a crankshaft of ratio ρ the cylinder comes to TDC every 2π/|ρ| of crankshaft 1 and fires once in a working cycle of its own crankshaft:

\`\`\`formula
cycle of j = 4π/|ρ| (four-stroke), 2π/|ρ| (two-stroke)                          (9.3)
\`\`\`

*Derived here.*

so that its firing angle is one of { τ_j + 2π k/|ρ| } and is reduced by (9.3), not by the cycle of crankshaft 1. The engine fires as before after the shortest whole number of revolutions that is a whole number of all these cycles; any
firing of a cylinder within it may be given in \`angles\`. A firing order needs crankshafts as fast as crankshaft 1. It is possible if the angles can be chosen so that they
rise through the cycle in that order. If it is not, the message names the cylinder that cannot fire in its turn and
lists orders that this crank can fire.

Short forms go the other way. With a firing order, even intervals (720°/n four-stroke, 360°/n two-stroke) and no crank angles,
the throws are placed so that each cylinder is at its nominal TDC when its turn comes:

\`\`\`formula
a_j = b_j − (firing angle of j),   shifted so that a_1 = 0                      (9.2)
\`\`\`

*Derived here from (1.2).*

Two cylinders on one pin must agree on it; where they do not, even firing is impossible on that crank and the file is refused with the reason.

![Strokes of three cylinders over 720 degrees](../images/theory/strokes.svg)

*Strokes of the in-line three \`examples/in-line-3.toml\`, firing order 1-3-2, over a cycle: P power, E exhaust, I intake, C compression (\`lanchester torque examples/in-line-3.toml\`).*

![Crank star of the in-line three with the numbers of the firings](../images/theory/firing-star.svg)

*Its throws as they stand at θ = 0, numbered as they fire.*

Firing does not enter the inertia loads. Gas does its work from each cylinder's own firing angle on: see [Torque of gas and inertia](torque.md).`,"theory/conventions#frame":`## Frame

* **z** is the axis of crankshaft 1, from the free end (where cylinder 1 is) to the flywheel.
* **x** is the axis of cylinder 1 in in-line and flat engines, and the bisector of the banks in a V. In a boxer or
  flat engine bank 1 points along +x and bank 2 along −x. Every other file states its angles itself.
* **y** completes the frame so that the crank turns from +x to +y. Seen from the free end, looking towards the
  flywheel, with x up, that is clockwise, and +y points to the right.
* \`rotation = "reverse"\` mirrors y: the crank still turns from +x to +y, every number stays as it is, and the picture is mirrored.
* The **origin** lies on the axis of crankshaft 1, midway between the first and the last throw plane, unless \`origin\` in the
  file says otherwise. All z of the expanded form count from there.

\`lanchester show\` prints the frame with every engine.

The plane across the crank is written as one complex number. All formulas of this book use it:

\`\`\`formula
w = x + i y                                                                     (1.1)
\`\`\`

A vector that turns with the crank has the factor \`e^{iθ}\`, one that turns against it \`e^{−iθ}\`.`,"theory/conventions#glossary":`## Glossary

Terms follow ISO 7967 (Reciprocating internal combustion engines: vocabulary of components and systems) where it has one, and
ISO 21940 for balancing.

| term | symbol | unit | meaning |
|---|---|---|---|
| crank radius | r | m | half the nominal stroke: axis of the crankshaft to axis of the crankpin |
| throw, crank throw | | | a crankpin with its two webs; each pin of a split pair is a throw of its own |
| web | | | arm between a main journal and a crankpin; webs 1 and 2 belong to throw 1, 3 and 4 to throw 2, and on |
| crankpin | | | the journal that the rod's big end runs on |
| counterweight | | | weight on a web or elsewhere on the crankshaft |
| connecting rod length | l | m | between eye centres |
| rod ratio | λ = r/l | 1 | crank radius over rod length; \`rod_ratio\`, never a bare \`lambda\` |
| big end, small end | A, B | | the rod's eye at the crankpin, at the piston pin |
| piston pin | | | ISO 7967-2; also wrist pin or gudgeon pin |
| cylinder offset | | m | distance of the cylinder axis from the crankshaft's axis (also désaxé) |
| piston-pin offset | | m | distance of the piston pin from the cylinder axis |
| net offset | e | m | their sum along +v |
| bank angle | | rad | between the banks of a V |
| split angle | | rad | from the pin of bank 1 to the pin of bank 2 of a split pair |
| top, bottom dead centre | TDC, BDC | rad | piston farthest from, nearest to the crankshaft |
| reciprocating mass | m_rec | kg | piston with pin and rings, and the rod's small-end mass |
| rotating mass | m_rot | kg | the rod's big-end mass, and the throw's own unbalance over r |
| residual inertia | J | kg m² | what two end masses have too much of the rod's moment of inertia |
| unbalance | U | kg m | mass times the distance of its centre from the axis of rotation (ISO 21940-2: amount of unbalance) |
| order | n | 1 | cycles per revolution of crankshaft 1; 1 is primary, 2 is secondary |
| forward, backward | f_n, f_−n | N | the parts of an order that turn with and against the crank |
| shaking force | F | N | of the moving parts on the block |
| couple | M_x, M_y | N m | moment of the shaking forces about the reference point |
| roll moment | M_z | N m | moment about z on the block |
| shaft torque | T | N m | inertia torque delivered at crankshaft 1 |
| firing order | | | cylinders in the sequence in which they fire, from cylinder 1 |
| firing interval | | rad | crank angle between successive firings |
| master rod, articulated rod | | | rod on the crankpin that carries knuckle pins, rod on a knuckle pin (also slave or link rod) |
| knuckle pin | k, κ | m, rad | pin on the master rod, at distance k from the crankpin and angle κ from the master rod's line |
| balance shaft | | | shaft with unbalance, geared to the crankshaft at ratio ±n |`,"theory/conventions#the-cylinders-own-frame":`## The cylinder's own frame

\`\`\`formula
u = e^{ib}    along the cylinder axis, away from the crankshaft
v = i u                                                                         (1.3)
\`\`\`

The **net offset** \`e\` is where the line of the piston pin passes the crankshaft's axis, along +v: the offset of the cylinder plus
the offset of the pin in the piston.`,"theory/rods#two-masses":`## Two masses

A rigid rod in plane motion has the mass m, the centre of gravity at the distance a from the big-end eye (b = l − a from the small end), and
the inertia I about that centre. Two point masses

\`\`\`formula
m_A = m b / l   at the big end        m_B = m a / l   at the small end          (6.1)
\`\`\`

*Sources: [DenHartog1956], ch. 5, and [Taylor1985], ch. 8.*

have the same mass and the same centre of gravity, so *the shaking force and the couple are exact*. The file may give
m_A and m_B directly ("weighed ends"), or m and a, or m alone: then two thirds are put at the big end and one third at the small end.

![A rod with its centre of gravity, and the two masses that stand for it](../images/theory/rod.svg)

*The rod and its two masses (6.1), which have the same mass and centre of gravity, but more inertia about it. Areas of the discs are as the masses.*`,"theory/counterweight#the-best-counterweight":`## The best counterweight

Given are the unbalance U = (least balance) × (full balance), ranges of r, h, R, α, of H or δ, and of the thickness t, and limits on mass, swept radius, inertia, width, shoulder angle and height. One of mass,
swept radius, polar inertia I about the crank axis (without the disc) and thickness is made as small as possible, over all shapes of the family with l_c ≥ 0 and y_c + R ≥ r.

**Thickness.** All limits get tighter and no objective gets smaller as t grows, so that the best t for a shape is the least one that has the unbalance,

\`\`\`formula
t = max( t_least, U/(ρ S) )                                                                     (22.27)
mass = max( ρ t_least A, U A/S )     inertia = max( ρ t_least I, U I/S )     U/(ρ t_most) ≤ S   (22.28)
\`\`\`

*Derived here from mass = ρ t A and U = ρ t S.*

Five variables are left: r, h, H, w and a = α/2; the range of R is R_least sin a ≤ w ≤ R_most sin a. In w the segment adds w² e₁, w³ e₂ and w⁴ e₃ to area, first moment about the chord and polar moment about its middle,

\`\`\`formula
u = 1 − a cot a      e₁ = a/sin² a − cot a      e₂ = u/sin² a − 1/3      e₃ = (3 e₁/2 − a)/sin² a      (22.31)
\`\`\`

*Derived here as power series with positive coefficients.*

The power series of u, of 1/sin² a and of e₁ have no negative coefficients, and so have these: each derivative grows with a, so that over a range of angles its ends bound it exactly. Area, S and I become sums of products of what is positive,
less the disc alone, which keeps their bounds over a box narrow. "Mass at most m" is then ρ t_least A − m ≤ 0 and U A − m S ≤ 0, and likewise for the inertia; "swept radius at most P" is r ≤ P, y_s² + w² ≤ P², y_c + R ≤ P (the corner of the rectangle is no
farther than that of the chord). A shape with the objective at most z satisfies a set of smooth terms φ_i(shape; z) ≤ 0, and an aim is a limit with a free level.

**A good shape** is found by sequential linear programming with a trust region from a few places spread over the ranges. It proves nothing.

**The proof** takes z a millionth below the level of that shape and shows that no shape satisfies all φ_i ≤ 0. The ranges are cut into boxes. With c the middle of a box, the second derivatives of each term bounded over the box by interval
arithmetic (automatic differentiation, twice), and s = x − c:

\`\`\`formula
φ_i(x) ≥ φ_i(c) + ∇φ_i(c)·s + d_i        d_i ≤ min over the box of ½ s·(∇²φ_i) s                (22.29)
\`\`\`

*Derived here: Taylor's theorem with the second derivatives bounded by interval arithmetic, [Moore2009].*

If the linear programme of these bounds has no solution, the box holds no such shape. If it has one, with the multipliers λ_i ≥ 0 of its optimum, then Σ λ_i φ_i ≤ 0 for any such shape, while the sum lies above its own linear part by at least

\`\`\`formula
d ≤ min over the box of ½ s·(Σ λ_i ∇²φ_i) s                                                     (22.30)
\`\`\`

*Derived here from (22.29), with the multipliers of the linear programme.*

which is zero where the sum is convex, often so where no single term is. Where it is not, the least that makes it so is added to the diagonal, pivot by pivot, and taken off again as a constant; the least of the convex quadratic that is left, slope and all, is bounded by
its tangent next to its minimum. Near the best shape this refutes whole boxes at once, so that the number of boxes hardly depends on the gap.
The sum may still bend down across the limits that hold there. For any better shape the slack of each row of the programme is at most what is left of z over its multiplier, so that these shapes lie in a parallelepiped that is thin across those rows, however they lie to the box; over
it the same quadratic is bounded again. The reduced costs of the programme cut off what cannot hold a
better shape; what is left is halved, in the variable in which the slope of what keeps the box open turns most: of the sum, where it would refute the box but for the d_i; else of the term that the programme's point breaks most. A point that breaks none is a better
shape. When no box is left, no shape of the ranges is better by more than a millionth, rounding apart (the intervals are not rounded outwards; 10⁻¹² of the scaled terms is kept for that).
A better shape that turns up on the way takes the place of the first. If no shape meets all limits, the same proof shows that, and for each limit the
nearest value at which there is one is the optimum with that limit as the objective.

![Drawing of a counterweight with its dimensions](../images/counterweight.svg)

*The lightest counterweight of \`examples/in-line-3-counterweights.toml\` within its ranges (\`lanchester counterweight design examples/in-line-3-counterweights.toml\`).*

**On its web.** Where the engine has a plain web (\`[crank.body]\`), what the shape shares with it beyond the disc is the web's. With the overlap O as a vector in the frame of the shape, its weight is
U_shape − ρ t O. The design is therefore repeated with the duty raised by what was lost, and the shape turned by the angle that the overlap has drawn its unbalance aside, until both stand still
to 10⁻¹⁰ of the duty and 10⁻¹¹ rad: O changes little with the shape, so that a few steps do. Mass, unbalance and inertia of a design are those that it adds to the crankshaft beyond the web as it is, in \`design\`, \`front\` and \`check\` alike; the exported part has the disc and
the flank that it covers besides, and its mass stands beside the other. Optimal and proved is the shape for the raised duty, among all that share as much with the flank.

**Within the envelope.** Where the file says what the crankshaft must stay clear of, the shape is first left free; if the best one keeps the wanted clearance all the same, by the proof below, it is the best of all that do. If not, it is searched within the envelope of everything
that moves past the web over the cycle: crankcase, pistons, liners and rods, those of the neighbours included. The envelope is a radius p by direction φ, counted from the direction of the counterweight. In a direction the distance f(s) of the point at the radius s, least over all angles,
changes by no more than the way gone, so that it is free as far as

\`\`\`formula
s_(k+1) = s_k + f(s_k) − least      p = lim s_k                                                      (22.73)
\`\`\`

*Derived here from the least distance, which changes no faster than the way gone.*

and every step of that walk is free as a whole, with the proof of each f. It is walked every two degrees to a quarter turn on both sides, of which the shape, being symmetrical, needs the nearer; between two directions the envelope is the circle through both ends,
y² + w² − b t·(y, w) = p₀ p₁ with t across the middle direction. What of it holds depends on the direction of the corner (y, w) of the chord, y = h + H. Every range of directions is therefore a problem of its own, and the proof covers all of them:

\`\`\`formula
corner:  w cos φ ≥ y sin φ at the first direction, ≤ at the last;   y² + w² − b t·(y, w) − p₀ p₁ ≤ 0                       (22.74)
arc:     y ≤ p cos φ and u (w² − y² + 2 p cos φ y − p²) + w (1 − u²)(y − p cos φ) ≤ 0 at every earlier φ, u = tan(a/2)     (22.75)
\`\`\`

*Derived here by plane geometry.*

The second says that the point (p, φ) lies outside the circle of the arc; a ray before the corner leaves the shape through its arc. Beyond the corner flank and rectangle come nearer to the axis all the time: the corner keeps to the least p of the directions behind it, which is sufficient,
and no restriction where the envelope does not come nearer again towards the crankpin. What is found is held against the exact clearance as \`check\` computes it; where it misses that between two directions, by micrometres, the envelope is drawn nearer by what is missed and the search
repeated, in the end to the circle that keeps clear whatever the shape (22.67). What does not keep the clearance then is not returned. Proved is the optimum within that envelope; no shape that keeps the clearance is better than the best one without it, which is told beside.
Rods pass the crank axis: the thickness ends where they would be nearer along the crank than is wanted.

**What fits.** The largest unbalance of all these shapes is found in the same way, with the unbalance as the objective at the largest thickness. It is the largest amount of a free weight there (\`most = "what fits"\`), less 3 · 10⁻⁵ of it, without which too few shapes are left to find one. It depends on the
direction of the weight: it is taken opposite to the crankpin or as the task gives it; where the optimum stands elsewhere and asks for more than fits there, what fits there becomes the bound and the optimum is found anew, at most six times, at last with the least of all directions.

**The front** between two objectives is made of optima of the first with the second limited to levels between its two ends, each with its own proof. It need not be convex. Ends are made
unambiguous by a second optimum at the level of the first, with a tenth of the proved gap for room. Without that room the shapes that are left are so few that the proof of an end may break off. Each design is for the raised duty of its web, and within the envelope of all its webs. A design that is adopted is found once more for each of them,
with no more of the second objective; at the end where there is no such shape, the one with the least of it.

![Mass of the counterweight against its swept radius](../images/counterweight-front.svg)

*Front between mass and swept radius of the same counterweight; every point is an optimum with its own proof (\`lanchester counterweight front examples/in-line-3-counterweights.toml\`).*

At a fixed swept radius and thickness the lightest shape with enough unbalance has its arc about the crank axis, where the shoulders stand out and no range is in the way: a piece of area at the point p changes A − μ S by 1 − μ y, so that it pays where y > 1/μ, out to the circle of the
crankcase.

**An evolutionary search**, the paper's way, is there for comparison: differential evolution over r, h, δ or H, R and α, with the thickness of eq. (22.27). A design that meets all limits is better than one
that does not, and only those that meet them all, to 10⁻¹², count. It proves nothing, and it depends on its seed: with the ranges that Table 3 suggests, most runs of 5000 designs stay beside the lightest, 0.2 % heavier, and runs for the least
inertia end up to 2 % above it, while the proof takes some thousand boxes. The first design that the paper prints there, brought to full balance, is also 0.2 % heavier than the lightest.`,"theory/cancellation#what-must-vanish":`## What must vanish

One order n of a force or couple is two complex numbers, the part that turns with the crank and the part that turns against it; one order of a
load with a single component (roll moment, force along x) is one:

\`\`\`formula
F_x + i F_y = f_+ e^{i n θ} + f_- e^{-i n θ}        M_z = Re( m e^{i n θ} )      (20.1)
\`\`\`

*Derived here from (4.1).*

A weight U on something that turns at \`ratio\` acts on n = |ratio| alone, and on the sense in which it turns: with its plane z and its axis x + i y

\`\`\`formula
f = (ratio w)^2 U        couple: i z f        roll moment: Im( (x - i y) f e^{i ratio θ} )   (20.2)
\`\`\`

*Derived here from (4.4), (1.4) and (5.6).*

So the orders vanish where the free unbalances u satisfy linear equations A u = b, with b the loads without the free weights, taken negative. Ties between weights are
more equations with nothing on the right, a given line makes u real, a given direction makes it real and not negative.
Loads are measured against those of all moving masses at their largest acceleration, unbalances against the one that makes such a load.
Then the entries of A are levers and factors about 1, known to rounding, and rows that depend on others to within 1e-12 (by a pivoted QR factorisation)
depend on them. What is below 1e-13 of the moving masses' loads counts as nothing.`,"theory/internal-moments#balance-rate-bay-by-bay":`## Balance rate, bay by bay

A *bay* is what lies between two neighbouring main bearings a, b. In the frame of the shaft its rotating parts, the throws' own unbalances and the big ends of their rods, U_k = amount e^{i angle}, load
its two mains by the shares (13.2) with A and B; the counterweights of the bay load them with A′ and B′:

\`\`\`formula
A = SUM over k of share_a U_k          B = SUM over k of share_b U_k                             (13.3)
rate = − Re( conj(A) A′ + conj(B) B′ ) / ( |A|² + |B|² )                                          (13.4)
\`\`\`

*Derived here by least squares; for one throw in its bay it is the usual rate, as in [Sae2008].*

The rate is the factor of the rotating parts that comes nearest to what the counterweights take off the two mains: |A′ + rate A|² + |B′ + rate B|² is least. For one throw in the middle of its bay, whatever its
webs carry, it is what is usual: the counterweights' unbalance opposite the throw over the rotating unbalance; what stands across the throw counts for nothing. Two throws between mains (three mains under an
in-line four, split pins, boxers) count as far as their mains feel them: pins in one plane by their sum, opposed throws by their couple, so that 100 % is reached when the mains carry nothing of what rotates in the bay.
A bay that brings nothing to its mains has no rate; weights beyond the end mains are in no bay. The free force and couple of an engine do not tell the rates: a symmetric crank is in balance with 0 % and with 100 %.`,"theory/internal-moments#loads-and-signs":`## Loads and signs

Forces F_k = F_x + i F_y act on the shaft in planes z_k: the unbalance of each throw and the big ends of its rods, the counterweights, and the share asked for (\`--bending-share\`) of the
force by which each rod's reciprocating parts act on the pin. Gas is left out. What lies before a section z acts on what lies behind it with

\`\`\`formula
Q(z) = SUM over z_k < z of F_k        M(z) = i SUM over z_k < z of (z_k − z) F_k        dM/dz = −i Q      (13.1)
\`\`\`

*Source: the statics of beams, as in [Shigley2011], ch. 3.*

bearing forces among the F_k. Between two planes Q is constant and M straight, so that extremes along the shaft lie in planes; over the cycle they are sought at 720 angles a revolution
at least, and refined.`,"theory/optimum#the-proof":"## The proof\n\nNothing that the solver says is believed. Take any vectors `y_k` at angles `θ_k` and prices `p_r ≥ 0` with\n\n```formula\nSUM G(θ_k)ᵀ y_k + SUM p_r h_r = 0                                               (12.3)\nSUM over k ∈ g of |y_k| ≤ c_g + SUM b_rg p_r                                    (12.4)\n```\n\nThen, for every x that holds the limits, since `y·g ≤ |y| t`,\n\n```formula\nSUM c_g t_g ≥ SUM y_k · g₀(θ_k) − SUM p_r B_r                                   (12.5)\n```\n\n*Derived here as the Lagrange dual of (12.2), [BoydVandenberghe2004], ch. 5, with a measure on the angles, [HettichKortanek1993].*\n\nThe right side needs no x: it is a lower bound for everything that these devices can do. The smallest relative change of the solver's multipliers makes (12.3)\nhold to rounding. What is left of it, a vector ρ, is charged at `|ρ| R`, R being a radius that holds every x that could be\nbetter; it follows from the mean square of the loads (Parseval). The answer states value, bound and their difference, the gap:\n\n```formula\ngap ≤ 10⁻⁸ max(value, 10⁻⁶ × the value without the devices)                     (12.6)\n```\n\nand an answer is optimal if that holds, or if the gap is below 10⁻¹³ of what all moving masses would do if none cancelled another (10⁻⁷ of their\nunbalance for amounts of weights); the method aims at (12.6) there too. Where a gap stays wider, the answer says so and calls itself *stopped*, not optimal.\n\nAt the optimum both sides agree, so that `y_k` stands along g, and only at angles where the load stands at its peak: the *active* angles. Their\nmultipliers `|y_k|` add up to the weight of the load. Lowering the load at one of them raises it at another.\n\n![Couple of an in-line three at its optimum with its active angles](../images/theory/active-angles.svg)\n\n*Couple of the in-line three of the guide ([Balancing](../guide/balancing.md), with balance shaft) at its optimum, as `lanchester balance` finds it: it stands at its peak at the active angles, and the bound (12.5) made of their multipliers meets it.*","theory/optimum#shadow-prices":`## Shadow prices

The multiplier of a limit is its shadow price: one unit more of it lowers the optimum by that many units,

\`\`\`formula
d(optimum) / dB_r = −p_r                                                        (12.7)
\`\`\`

*Source: [BoydVandenberghe2004], section 5.6.*

in N per kg m for a largest amount, in N per N m for a limited couple. It belongs to the first stage that the limit holds up, and has that stage's unit. A weighted
sum \`SUM w_g t_g\` is a stage like any other; with weights \`1/value\` its terms are shares of the values given for them, the sum has no unit, and a price is that of the sum, per N m for a limited couple. Limits with price 0 are not active. Where limits cannot
hold together, the smallest common factor s that mends them is found, with the closest value that each can reach alone:

\`\`\`formula
minimise s   with   SUM b_rg t_g + h_r x ≤ s B_r                                (12.8)
\`\`\`

*Derived here.*`,"theory/branch-and-bound":`# Choices: branch and bound

A free unbalance is linear in every load, so that the smallest peak is one convex programme. Some questions are not: a weight
whose plane is to be found, a shaft whose axis is, an amount that is given or must not be less than something, a device that may be left out. Each of them is a
*choice*, and a set of choices a *box*: every plane in a stretch, every phase in a sector, every device used, not used or open.

**Bound.** Each box has a convex programme that loses nothing of it. Its certificate is a lower bound for everything in the box.

A weight \`U\` in a plane \`z\` between \`z_1\` and \`z_2\` acts as two weights at the ends,

\`\`\`formula
U_1 = (z_2 − z)/(z_2 − z_1) U      U_2 = U − U_1                                 (18.1)
U = U_1 + U_2      z U = z_1 U_1 + z_2 U_2      |U| = |U_1| + |U_2|              (18.2)
\`\`\`

*Derived here from the lever rule.*

so its force, its couple and its amount (hence largest amounts, added mass and added unbalance) are those of the pair. The programme lets \`U_1\` and \`U_2\` go their own ways;
only where they are not parallel does it allow more than the task. In a stretch of length \`w\` and a sector of phases of width \`β\` that is at most

\`\`\`formula
|z_1 U_1 + z_2 U_2 − z (U_1 + U_2)|  ≤  w/2 · tan(β/2) · |U|                     (18.3)
\`\`\`

*Derived here from (18.1): the largest departure over z.*

for the best \`z\`: halving either halves the error. A weight of given direction needs no division at all. The
axis of a shaft is treated alike: only the roll moment, \`conj(x + i y)\` times the sum of the shaft's weights, depends on it, and the corners of its area take the place of the ends.

![A weight between two planes, and a sector beyond its chord](../images/theory/box.svg)

*Left: U acts as U_1 and U_2 at the ends of its stretch. Right: amounts above U_least lie beyond the chord of their sector (18.4).*

The bending moment of a crankshaft has a kink in the plane of a load. It is judged in the planes outside every stretch, where the pair acts as the
weight does, which is a bound from below; with the stretch divided all planes count.

A least amount is a ring. In the sector of phases from \`α\` to \`α + β\` it lies beyond its chord,

\`\`\`formula
Re U e^{−i (α + β/2)}  ≥  U_least cos(β/2)                                       (18.4)
\`\`\`

*Derived here the chord of a sector.*

Of \`k\` optional devices at most \`m\` are used; while they are not decided, \`SUM |U| / U_most ≤ m\`.

**Branch.** The box with the lowest bound is divided where its programme goes farthest beyond the task: first devices, then the
choice with the largest force or couple that is not really there. Stretches are halved. Where the phases of \`U_1\` and \`U_2\` differ by less than half of the sector,
a narrow part around the phase of \`U\` is cut out of it, a quarter as wide as they differ; that leaves out both of them. Where stretch and sector can both
be divided, the wider is divided first; unless that halves what is open, summed over its parts, the other division is examined too, and the one that leaves less is kept. So a weight that may slide
along the crank without loss is proved by its phase alone, with the whole stretch in one box. The area of an axis and the sector of its shaft are halved,
the wider first: narrow parts and a second division cost more boxes there than they close. Devices that are the same but for their names are looked at in one order only.

**Best so far.** Near every programme's optimum lies a choice of the task: planes at the mean of the two ends, a least amount kept
beyond a tangent of its circle, which is convex again. Its own programme is solved; planes with the phases kept, and phases with the planes kept, are then improved in turn.

**Shadow prices.** A limit has the shadow price that it has with the choices kept: devices, places, directions of given and least amounts. A least amount is
kept beyond the tangent of its circle, \`Re U e^{−i φ} ≥ U_least\`, which moves with the circle: the multiplier of that row is the shadow price of the amount, how much the
stage would fall if it were one unit smaller. A given amount is an equation, whose multiplier may have either sign: negative where a larger amount helps. It is stated for
the first stage alone; what a later one gains would be at the cost of that.

**Catalogues.** A weight that is made in steps, or is one of a list, has a box of its amounts: from one of them to another. Its programme knows the least and the largest of the box, \`U_first ≤ |U| ≤ U_last\`, a range
like any other (18.4). The box is divided at the amount below that of the programme's optimum, so that this one lies in neither part; a box of one amount is that of a given amount. Equal parts share their box. Near an
optimum the nearest amounts are tried, then those one step up and down in turn. Here the loads of the main bearings and the bending moment are searched for as well, as amounts that force and couple do not see would be left to chance.

**Costs.** A device that costs something by being used is a choice of use. While it is open, its fixed cost counts by the share of its largest amount, \`fixed |U| / U_most\`, which is no more than what it costs in the end; of a
shaft by the largest share of its weights. Costs per amount are convex.

**Mains inside a stretch.** Beyond a main bearing other mains carry a weight. A stretch of a crankshaft therefore has a part of the weight at every main inside it besides its two ends,
each with an unbalance of its own; a weight in one plane has its parts at the two neighbours of the plane alone, so that nothing is lost, and the stretch is divided at a main where the
parts are not such.

**What nobody asks about.** Where the axis of a shaft is free and no criterion sees it, it is found by what decides among equals: force, couple, then the
roll moment. It is searched through 200 boxes at most, to 10⁻⁵ of its value. The loads of the main bearings and the bending moment decide among equals with the choices kept; who wants choices
made for their sake names them. Where the least weights are asked for and nothing sees the axis, it stands in the middle.

**Proof.** The search aims at the gap of [eq. (12.6)](optimum.md): 1e-8 of the best, or of a millionth of the unbalanced load if that is larger. A box that cannot
hold anything better by more than 0.45 of it is closed. Later criteria search the boxes that are left, and may give up another 0.45 of the earlier ones; the
rest is for rounding. A later criterion may gain much from little: where an earlier one has a smooth minimum, the square root of what it gives up. A box in which an earlier criterion is
worse than it may be is empty, and is proved to be so by that criterion where the certificate of the later one is spoiled by it.

**An early end.** The gap, the largest number of boxes for one criterion (2000) and a time limit are settings; the time is the caller's, who is asked before each box and may end the search at any of them. A gap γ wider than 1e-8 stands in
its place above: later criteria may then give up 0.45 γ of an earlier one. However a search ends, its bound is the least of those of all boxes that are open: a box that is being
divided stays whole with its own bound, and a box that nobody examined has the bound 0, as peaks, masses and unbalances are not negative. Each of these holds for everything in its box, so that the stated gap is a true one after any number of boxes. The value is that of the best
choice tried so far, which holds all limits. A box is no longer divided when twelve in a row
owe most of what is open to rounding: then the answer says that it is rounding. Limits that no box can hold are
proved impossible in the same way, and so is the nearest value of each.

![Best value and lower bound over the number of nodes](../images/theory/bounds.svg)

*Best value and lower bound of the first stage of \`examples/twin-270-choices.toml\`, searched with at most so many nodes (\`lanchester balance examples/twin-270-choices.toml\` with \`--max-nodes\` from 1 to 80).*

What takes many boxes: several given amounts, or several weights of free phase in free planes, that all matter to one peak. A given direction, a
smaller stretch and a largest amount near what is needed help most. Where the optimum leaves a whole range of
phases equally good, the boxes along it are all looked at.`,"theory/bearings#forces-of-one-piston":`## Forces of one piston

With the gas force f towards the crank (24.1), the reciprocating mass m, the piston's own mass m_p, and q, W, β of the [kinematics](kinematics.md), in the cylinder's frame:

\`\`\`formula
F = −m s̈ − f                     piston and small end, along u                 (26.1)
N = −(q F + J β̈) / W             wall on the piston, along v                   (26.2)
X = (m_p s̈ + f) u − N v          rod on the piston pin                         (26.3)
R = F u + N v                    rod on the crankpin, without its big end      (26.4)
\`\`\`

*Sources: Newton's law for piston and rod, [DenHartog1956], ch. 5, and [Taylor1985], ch. 8, here with the offset and the rod's true inertia.*

N follows from the moments on the rod about its crankpin; J is what the two-mass rod misses of the rod's inertia, −(6.2). The **side thrust** is −N, piston on wall. The bearing of the big end carries R with the
centrifugal force of the big-end mass, m_A r Ω². An articulated rod gives its force to the knuckle pin, with its big-end mass there; the master hands it on to the crankpin, and its own piston takes the thrust

\`\`\`formula
N_m = −Im( conj(K − A) (P − m_K K̈) ) / W_m                                       (26.5)
\`\`\`

*Derived here from the moments on the master rod about its crankpin.*

that the force P on the knuckle pin K makes about the crankpin A. The master's piston pin and wall carry it too.

Where an articulated rod lies beside its master along the crank axis, its force P − m_K K̈ still loads the crankpin as in the rod's own plane: the master rod hands on what the distance of the planes asks for as a couple. The thrust N_m
comes from the master's wall through the master's piston pin: it loads the crankpin in the *master's* plane. Only so do the forces on the block keep the balance of their moments about x and y.

![Gas force, side thrust, and forces of the rod on piston pin and crankpin](../images/theory/piston-forces.svg)

*The forces of (26.1) to (26.4) on a light piston and rod during the power stroke: f, N and X act on the piston, R on the crankpin.*`,"theory/bearings#main-bearings":`## Main bearings

Throw by throw, as if the shaft were cut at each main bearing (see [Inside the crankshaft](internal-moments.md)): a force in the plane z is carried by the two mains beside it as by a lever,

\`\`\`formula
F_j = SUM over rods of share_j R + e^{i n θ} SUM over turning masses of share_j U Ω² e^{iα}        load of main j      (26.6)
\`\`\`

*Source: the lever rule, as in [Taylor1985], ch. 8.*

share_j is the lever's share of main j in the plane of the force; of R the thrust N_m acts in the master's plane. U is the unbalance of a turning mass, α its angle on the
crankshaft. Turning masses are the throws' own unbalance, the big ends and the counterweights. Real crankshafts are statically indeterminate: this is the usual first estimate, and it is exact for a shaft with two bearings. Weight, gears, friction, play and
the oil film are left out.`,"theory/films":`# Oil films of bearings

\`bearings --film\` floats every main and big-end bearing of the engine on its oil. This page says what is solved. e is the journal's centre from the bearing's, n(a) = (cos a, sin a), c the radial clearance,
R radius, L length, μ viscosity; w_m is the mean of the angular speeds of journal and shell: Ω/2 in a main bearing, (Ω + rod's)/2 in a big end.

\`\`\`formula
h = c − e·n                              film thickness, journal and shell parallel             (45.1)
v = e' − w_m z × e                       motion as the film sees it: it closes where v·n > 0     (45.2)
(1/R²) ∂/∂a(h³ ∂p/∂a) + ∂/∂z(h³ ∂p/∂z) = −12 μ v·n                                               (45.3)
F = −∫ p n R da dz                       film on journal                                         (45.4)
\`\`\`

*Sources: [Reynolds1886]; with squeeze and whirl in one velocity as in [Booker1965].*

![Journal and shell with eccentricity and film thickness](../images/theory/film.svg)

*Journal and shell with e, n(a) and h of (45.1); the clearance is drawn much too large.*`,"theory/films#cavitation":"## Cavitation\n\n| model | condition |\n|---|---|\n| `full` | none: negative pressures are kept (Sommerfeld) |\n| `gumbel` | negative pressures of the full film are set to zero (Gümbel) |\n| `reynolds` | p ≥ 0; pressure and slope vanish together where the film ruptures (Swift, Stieber): an obstacle problem, solved by an active set that starts from that of the instant before |\n| `mass-conserving` | oil is conserved in the cavity too (Jakobsson, Floberg, Olsson): pressure and emptiness r are complementary, r carried along with the mean surface, upwind |","theory/flywheel#cyclic-speed-fluctuation":`## Cyclic speed fluctuation

Inertia torque is nothing but the change of J(θ). With a load that takes T_mean at every angle, the energy integral gives the speed in closed form:

\`\`\`formula
½ J(θ) ω² = C + INTEGRAL from 0 to θ of (T_gas − T_mean) dθ                      (25.7)
2π R / ω_mean = INTEGRAL over R revolutions of dθ/ω                              (25.8)
\`\`\`

*Derived here from the balance of energy.*

The second equation sets C, so that the mean speed, angle over time, is the one asked for; it falls steadily with C and has one root. Without gas the load is 0 and J(θ) ω² is constant: the inertia of pistons and rods alone makes
the speed swing.

![Speed over its mean over 720 degrees](../images/theory/speed-fluctuation.svg)

*What comes of it at 1600 rpm, by (25.7): the speed over its mean, less 1. It rises while the torque is above its mean.*

The engine file may give more torques over the angle: \`torque\` of \`[simulation]\`, a sum of orders on crankshaft 1 (or the orders of a curve from a file) beside the gas or in its place, and a table of \`[load]\` over the angle, for a load that sits on crankshaft 1 itself. The load takes the mean of
all torques, and beside it what its table varies about its own mean L_mean,

\`\`\`formula
T_gas − T_mean  becomes  T_gas + SUM over orders of ( a sin nθ + b cos nθ ) − L(θ) − ( their mean )         (25.9)
\`\`\`

*Derived here from (25.7).*

over the shortest whole number of revolutions after which all repeat. With a = 9500 N m, b = −5700 N m at order 2 on a mean of 20 000 N m this is the flywheel problem of the textbooks: ΔE is the amplitude, 11 079 J, and 1 % at 180 rpm takes 3118 kg m² by (25.4).

An inertia that is not known is not taken as 0: without that of the flywheel or of the crankshafts there is no cyclic speed fluctuation, and the answer names the key that gives it. The equations have a solution however light the engine is; below a
lowest speed of 5 % of the mean it says nothing, since no load takes the same torque there and no cycle keeps its pressures: the engine counts as stopped, and the answer has the flywheel with which the lowest speed just
keeps these 5 %. Given a wanted C_s, the flywheel
for which (25.7) just keeps it is found by bisection beside the one of (25.4). Where the inertia of the crankshafts is not known, the flywheel found includes it.`,"theory/flywheel#energy":`## Energy

The load takes a constant torque, the mean of T. What T has more or less than its mean goes into the speed:

\`\`\`formula
E(θ) = INTEGRAL from 0 to θ of (T − T_mean) dθ                                  (25.1)
ΔE   = max E − min E                    largest excess energy                   (25.2)
\`\`\`

*Source: [Shigley2011], ch. 16.*

T is gas and inertia together. E has its extremes where T crosses its mean; each crossing is found as a root and the stretches between knots are integrated by a Gauss rule, so that ΔE is that of the
continuous angle.

[Louvigny2008] calls "variation of energy" another quantity, which stands here under its own name:

\`\`\`formula
A = INTEGRAL over the repeat period of |T − T_mean| dθ                             (25.3)
\`\`\`

*Source: [Louvigny2008], its "variation of energy".*

The repeat period is the shortest after which the torque repeats: 720° for a single and for a twin out of phase, 360° for a twin in phase, 180° for an in-line four. A counts every rise and every fall,
over however many peaks the period has: with one rise and one fall it is 2 ΔE, else more. That its tables call for "nearly double the flywheel" out of phase is in part the comparison of 720° with 360°.

![Torque of a three-cylinder engine over 720 degrees](../images/theory/torque-of-three.svg)

*Torque of the generator set \`examples/generator-set-3.toml\` (\`lanchester torque examples/generator-set-3.toml\`). The areas between the whole torque and its mean, from one crossing to the next, are what E rises and falls by.*`,"theory/flywheel#inertia":`## Inertia

\`\`\`formula
C_s = (ω_max − ω_min) / ω_mean        J = ΔE / (C_s ω²)                           (25.4)
\`\`\`

*Source: [Shigley2011], ch. 16.*

is the inertia of everything that a fluctuation C_s needs, to the first power of C_s. The crank train has part of it. From the kinetic energy ½ J(θ) ω²

\`\`\`formula
J(θ) = J_0 + SUM over pistons of n² ( m s′² + J_rod β′² + m_K |K′|² )           (25.6)
\`\`\`

*Derived here from the kinetic energy of all that moves.*

J_0 holds what does not change with the angle: flywheel, crankshafts with their counterweights, balance shafts whose inertia the file gives, big ends at their crankpins, each times the square of its speed over that of crankshaft 1, so whichever way it turns; m and J_rod = −(6.2) are those of [Loads](loads.md) and [Rods](rods.md), m_K the big-end mass
of an articulated rod, which moves with its knuckle pin K. The flywheel needs what is left beside the mean of J(θ).`,"theory/pressure#curves":`## Curves

A pressure is a periodic function of the crank angle, kept in cubic pieces from knot to knot:

\`\`\`formula
y(t) = a_i + b_i u + c_i u² + d_i u³,   u = t − t_i,   t_i ≤ t < t_(i+1)            (23.1)
\`\`\`

Pieces may jump at their ends, as the pressure of an ideal cycle does where heat is released at constant volume. Values, slopes, means and extremes of such a curve are exact, and so are weighted sums
of curves, which is how traces of several speeds are interpolated. Its harmonics are integrals over the pieces:

\`\`\`formula
y_n = 1/P INTEGRAL over a period of y(t) exp(−i n 2π t/P) dt                       (23.2)
\`\`\`

Samples of a smooth quantity become the periodic cubic spline through them: twice continuously differentiable, with M_i = y″(t_i), h_i = t_(i+1) − t_i and
s_i = (y_(i+1) − y_i)/h_i

\`\`\`formula
h_(i−1) M_(i−1) + 2 (h_(i−1) + h_i) M_i + h_i M_(i+1) = 6 (s_i − s_(i−1))           (23.3)
\`\`\`

*Source: [DeBoor1978].*

for all i, the indices periodic.

![Pressure over 720 degrees](../images/theory/pressure.svg)

*Pressure over the working cycle of the single cylinder \`examples/single-gas.toml\`, counted from firing top dead centre (\`lanchester torque examples/single-gas.toml\`).*`,"theory/mounts#natural-motions":`## Natural motions

\`\`\`formula
K s = ω² M s,        sᵀ M s = 1                                                          (27.5)
\`\`\`

*Source: [DenHartog1956], ch. 4.*

The share of the kinetic energy in coordinate k is

\`\`\`formula
e_k = s_k (M s)_k,        SUM over k of e_k = 1                                          (27.6)
\`\`\`

*Derived here from (27.5): the sum over k is sᵀ M s.*

a product of inertia couples two rotations, and one share can then be negative. A mode with a share near 1 moves in that coordinate alone; what is missing is its coupling. The
share of a mount in the elastic energy is (B_j s)ᵀ K_j (B_j s) over their sum. With a table, ω is the frequency at which the stiffness is that of the table there.

![A mode of a block on its mounts in two views](../images/theory/mount-mode.svg)

*Mode 4 of the block of \`examples/in-line-4-mounts.toml\`, with 47 % of its kinetic energy in roll, at rest and at the end of its swing, from the side and from the free end (\`lanchester mounts examples/in-line-4-mounts.toml\`).*

Damped modes are the roots p of

\`\`\`formula
( p² M + p C + K ) s = 0,        damping ratio −Re p / |p|                              (27.7)
\`\`\`

*Derived here from the equations of motion without load.*

with the complex K of (27.2). Of each pair the root with positive frequency is kept; a motion that does not oscillate has two.

The **torque-roll axis** [JeongSingh2000] is the line about which the free block turns under a torque about z. Its centre stays, and the angular acceleration is
J⁻¹ e_z: the line through the centre along J⁻¹ e_z. Mounts that hold the block so that one mode turns about this line are excited in that mode alone by the
roll moment.

The **centre of stiffness** [Loncaric1987] is where the part of K that couples translation and rotation is symmetric. With K = ( A B ; Bᵀ D ) about the centre of mass, it lies at r with

\`\`\`formula
( tr(A) E − A ) r = −v,        [v]× = B − Bᵀ                                           (27.8)
\`\`\`

*Source: [Loncaric1987].*

If the coupling vanishes there, a force through the point does not turn the block: it is the elastic centre. The principal directions are those of A.`,"theory/mounts#shaken":`## Shaken

Force and couple of an order, of (4.1), are the complex amplitudes

\`\`\`formula
F_x = f_n + conj f_−n        F_y = −i ( f_n − conj f_−n )        force = Re( F e^{inθ} )    (27.9)
\`\`\`

*Derived here from (4.1).*

the couple alike, the roll moment as it is, all carried over to the centre. At the angular frequency nω of order n at the speed ω

\`\`\`formula
( K(nω) + i nω C − (nω)² M ) Q = F        force on mount j = ( K_j(nω) + i nω C_j ) B_j Q    (27.10)
\`\`\`

*Derived here from the equations of motion.*

What turns in the block adds to both matrices. A rotor of polar inertia J that turns at ρ ω has the angular momentum ρ J ω along the crank axis, which the block carries about with it; its change is a couple on the block. All rotors
together, shafts against the crank counting negative, have

\`\`\`formula
J_rel = SUM over rotors of ρ J        gyroscopic couple on the block = −J_rel ω φ′ × z = J_rel ω ( −φ_y′ , φ_x′ , 0 )        (27.12)
\`\`\`

*Derived here from the moment of momentum of the rotors.*

so that a pitching couple yaws the block too. In roll, a drive from the ground that keeps the speed constant relative to the block turns every rotor on as the block rolls. By virtual work that takes the torque J_rel φ_z″, which the block
would otherwise have to find:

\`\`\`formula
( I_zz − J_rel ) φ_z″ = M_z        C_xy += J_rel ω,   C_yx −= J_rel ω,   M_zz −= J_rel        in (27.10)        (27.13)
\`\`\`

*Derived here by virtual work.*

A single crank at ρ = 1 that no drive turns on keeps its absolute speed and gives the same. J comes from \`[flywheel]\`, from \`inertia\` of each \`[[shaft]]\` and, in \`mounts\`, from \`[crank.body]\`; what nobody gives counts as 0, and the result says how much is
counted. Modes and transmissibility are those of the engine that stands. Beyond (27.13) a simulated block differs only by the masses that move in it, in proportion to them: \`crosscheck\`, condition C.

Inertia loads of an order grow with the speed squared, exactly; gas brings its own for each speed, half orders among them. Orders superpose: the largest resultant of the sum over the
cycle is found over the continuous angle. The amplitude of a single order is the major half axis of the ellipse that its force draws in space,

\`\`\`formula
½ ( |V|² + |V·V| ),  square root of it        V·V without conjugate                      (27.11)
\`\`\`

*Derived here as the major half axis of an ellipse in space.*

Order 0 does not turn; it belongs to (27.4). **Transmissibility** is what all mounts together pass on over what excites the block, forces and moments about the centre each by
the root of the sum of squares of their amplitudes.

![Largest force at a mount over speed, and by order](../images/theory/mount-force.svg)

*Force on the engine-side mount of the same block over speed: the largest over the cycle, and the amplitudes of the strongest orders. Above all natural frequencies an inertia force of order n, which grows with the speed squared, leaves a constant force.*

Two limits frame every curve. Mounts that are stiff, or loads that are slow, share the load as (27.4) would, K_j B_j K⁻¹ F, which every result tells beside the force itself: with equal springs in all directions the
mounts take the forces with the least sum of squares. On soft mounts, or far above all natural frequencies, the block moves as if it were free, Q = −M⁻¹ F/(nω)², and the
mounts feel that motion times their stiffness.`,"theory/torsion#forced-vibration":`## Forced vibration

\`\`\`formula
T(θ) = T_0 + Re Σ T_k e^(i n_k θ),    n_k = k n_1                                                           (50.5)
(K + i ω C − ω² J) φ = T,    ω = n_k W,    T_shaft = (k (1 + iη) + i ω c) ρ (φ_from − φ_to)                 (50.6)
\`\`\`

*Derived here from (50.1), order by order.*

n_1 is ½ for four strokes. Torques of the gas come from the [forces on the pins](bearings.md), those of the masses from (50.13), cylinder by cylinder in the phase in which it fires. One solution is an elimination along the tree by dynamic stiffnesses g in series, in which nothing nearly equal is subtracted:

\`\`\`formula
g = −ω² J + i ω c + Σ k g_c/(k + g_c),    φ − φ_parent = (T − g φ_parent)/(k + g),    T_parent += T k/(k + g)    (50.3)
\`\`\`

*Derived here by eliminating the tree from its ends.*

Amplitudes *in true phase* are half of largest less least value of the sum of all orders over the cycle; the *sum of amplitudes*, named as such, is what older practice takes for it. Stress is nominal: torque over the polar section modulus of the weakest journal or pin of a piece. Mean torque is taken at the end of the
chain. At every speed the power that the torques put in is the power that dampers take; the result prints how nearly.

![Natural frequencies and orders over speed](../images/theory/campbell.svg)

*Natural frequencies and orders of the same engine over speed; dots where the strongest orders meet a natural frequency.*

![Twist between nose and flywheel over speed](../images/theory/torsion-twist.svg)

*Twist between nose and flywheel: the amplitude of all orders in true phase, and of the strongest alone.*

**Star of an order.** Equal torques of all cylinders in the phases of their firings θ_i:

\`\`\`formula
v_i = e^(−i n (θ_i − θ_1)),    sum = |Σ φ_r,i v_i|                                                          (50.10)
\`\`\`

*Sources: [DenHartog1956], ch. 5, and [KerWilson1956].*

with φ_r = 1 for a rigid crankshaft, else the shape of mode r over the largest of its throws. Critical speeds are listed by the *modal torque* |Σ T_k φ_r| of the true torques.`,"theory/torsion#free-vibration":`## Free vibration

\`\`\`formula
(K − ω² J) φ = 0                                                                                            (50.2)
\`\`\`

*Sources: [DenHartog1956], ch. 5, and [KerWilson1956].*

by the symmetric matrix J^−½ K J^−½. Damped modes are the roots s of det(s² J + s C + K(1 + iη)), found together by Aberth's iteration [Aberth1973] after rigid turning is taken out exactly. Holzer's table makes the chain swing at ω and sums inertia torques from the ends:

\`\`\`formula
T_shaft = Σ J ω² φ over all before it,   φ_next = φ − T_shaft/k,   what is left at the last station is 0 at a natural frequency  (50.4)
\`\`\`

*Source: Holzer's table, [DenHartog1956], ch. 5.*

![Shapes of the first modes over the stations](../images/theory/torsion-shapes.svg)

*Shapes of the first modes of the six-cylinder engine \`examples/in-line-6-torsion.toml\` over its stations: 1 ring of the damper, 2 hub, 3 to 8 throws, 9 flywheel, 10 and 11 driveline (\`lanchester torsion examples/in-line-6-torsion.toml\`).*`,"theory/torsion#dampers":`## Dampers

A viscous damper is a ring on a damper c, a rubber damper a ring on k (1 + iη), a tuned viscous one both. For one mass J on a spring, ring μJ:

\`\`\`formula
without a spring  c = 2 J_ring ω_n/√(2 (1 + μ)(2 + μ)),    peak 1 + 2/μ,    at ω² = 2 ω_n²/(2 + μ)           (50.7)
with a spring     f = 1/(1 + μ),    ζ = √(3 μ/(8 (1 + μ)³)),    fixed points √(1 + 2/μ)                      (50.8)
fixed points      g⁴ − 2 g² (1 + f² + μ f²)/(2 + μ) + 2 f²/(2 + μ) = 0                                       (50.9)
\`\`\`

*Source: [DenHartog1956], section 3.3.*

For a whole engine \`--tune\` computes the peak over the speed range, refined between the speeds, at settings evenly spaced on a logarithmic scale over a factor of 1000 about the mode in which the ring swings most, and refines the least between its neighbours. The curve is printed with its number of minima: that is the proof. For one mass it gives (50.7)
to 1e-6; of a tuned damper the true optimum lies 0.2 to 0.5 % above the fixed points, because the two peaks are not exactly at them.

![Peak twist over the damping of the damper](../images/theory/damper-tuning.svg)

*Peak twist over the speed range of the same engine against the damping of its damper (\`--tune damping\`): one minimum, the dot.*

![Twist by order 6 over speed with three dampings](../images/theory/damper-response.svg)

*Twist of the same engine by order 6 over speed with three dampings of its damper (\`lanchester torsion\` with \`damping\` changed; the best as \`--tune damping\` finds it): all pass through nearly one point, and the best has its peak near it, as (50.7) says of one mass.*

**Centrifugal pendulums**, N masses m on a length l at the pivot radius R:

\`\`\`formula
2 T = N m ((R + l) φ' + l ψ')²,    2 V = N m R l W² ψ²                                                       (50.11)
ψ/φ = n² (R + l)/(R − n² l),    J(n) = N m (R + l)²/(1 − n² l/R)                                             (50.12)
\`\`\`

*Derived here from Lagrange's equations, to first order in ψ; the tuning √(R/l) as in [DenHartog1956], ch. 5.*

With χ = ψ + φ (R + l)/l that is an inertia N m l² at the ratio (R + l)/l on a spring N m R l W²: a branch of the tree like any other, whose stiffness grows with the square of the speed. Order √(R/l) meets an infinite inertia. Swings beyond some 30 degrees are outside linear theory, and the result says so.`,"theory/flexible#elements":`## Elements

Tetrahedra with 10 nodes (C3D10), wedges with 15 (C3D15) and hexahedra with 20 (C3D20), numbered as in CalculiX. With r, s, t the coordinates of an element of its own, L the area or volume coordinates:

\`\`\`formula
wedge:  corner L_i (1 ∓ t)(2 L_i − 2 ∓ t)/2      edge 2 L_i L_j (1 ∓ t), L_i (1 − t²)                 (43.1)
\`\`\`

*Source: the quadratic shape functions of textbooks, [Bathe1996], ch. 5.*

The upper sign is that of the lower triangle. With λ and μ Lamé's constants and g the gradients of the shape functions,

\`\`\`formula
K_ij = ∫ λ g_i g_jᵀ + μ (g_j g_iᵀ + (g_i · g_j) I) dV                                               (43.2)
M_ij = ∫ ρ N_i N_j dV I                                                                             (43.3)
\`\`\`

*Source: [Bathe1996], ch. 4 and 5.*

The stiffness is integrated as CalculiX does it (4, 3 × 3 and 27 points), the mass exactly for elements with straight edges. Stress at nodes is extrapolated from the superconvergent points (4, 3 × 2, 8), averaged within one
material and reported with its jump, the largest less the smallest von Mises stress of the elements that meet there:

\`\`\`formula
σ_v = sqrt(((σ_x − σ_y)² + (σ_y − σ_z)² + (σ_z − σ_x)²)/2 + 3 (τ_xy² + τ_yz² + τ_zx²))               (43.4)
\`\`\`

*Source: von Mises, as in [Shigley2011], ch. 5.*

Against exact and published numbers: the thick plate of NAFEMS (LE10, 20-node bricks, −5.38 MPa at its point D) comes to −5.50, −5.41 and −5.39 MPa with 4 × 6 × 2, 8 × 12 × 4 and 12 × 18 × 6 elements; a turning cylinder with a bore of a fifth of its diameter has the hoop stress of the exact solution there to 4·10⁻⁴ with every kind of element;
the first three torsional modes of a free round bar are those of f_n = (n/2L) √(G/ρ) to 10⁻⁴.`,"theory/strength#fatigue-at-a-point":`## Fatigue at a point

Where the stress history of a point is known, Findley's criterion seeks its worst plane. σ_n is the normal stress on a plane, τ_a the radius of the smallest circle about the path of the shear stress in it; σ_W and τ_W are the fatigue limits in alternating bending and torsion.

\`\`\`formula
f = max over planes of τ_a + k max σ_n                                                             (49.13)
2/(1 + k/√(1 + k²)) = σ_W/τ_W    allowed f = τ_W √(1 + k²)                                         (49.14)
\`\`\`

*Source: [Findley1959]; (49.14) is derived from (49.13) here, by the two limits.*

Planes are tried every 10° and searched about to 1e-6 rad. Bending with the amplitude σ_W and torsion with τ_W reach the allowed value exactly. Two safeties: how much all stress may grow, and how much its difference from the mean over the cycle may grow while the mean stays.

\`stress cycle\` judges the stress of (51.11) so, at every node of a fillet over the cycle that was run. \`stress fatigue\` takes these histories from finite elements without vibration. Forces on a pin are a pressure over the half of its surface that faces them, so the pattern turns with the force. Unit forces e in 24 directions a₀ < a₁ < ... are solved for each pin, and the centrifugal field once; a force F with the direction a between two of
them is their sum:

\`\`\`formula
F = |F| (sin(a₁ − a)/sin(a₁ − a₀) e₀ + sin(a − a₀)/sin(a₁ − a₀) e₁)                                (49.15)
\`\`\`

*Derived here by the parallelogram of forces.*

Every speed and angle follows by superposition. In each fillet the node with the largest f is sought; nodes whose upper bound, the largest shear stress of what varies plus k times the largest principal stress, lies below a value found are passed over. Finish, size and gradient of stress are factors on both limits, off unless given.`,"theory/flexible#convergence":`## Convergence

Three meshes with elements h, h/1.4 and h/2, and n, about 1.4 n and 2 n across a fillet, show the order p with which a number f comes to rest (Richardson), and how far off it may be (Roache's factors of safety):

\`\`\`formula
(f₁ − f₂)/(f₂ − f₃) = (h₁ᵖ − h₂ᵖ)/(h₂ᵖ − h₃ᵖ)      f* = f₃ + (f₃ − f₂)/((h₂/h₃)ᵖ − 1)      band = 1.25 |f* − f₃|    (43.15)
\`\`\`

*Source: [Roache1994].*

Displacement, energy and frequencies count by h, the peaks of fillets by 1/n. Without an order from 0.5 to 6 the value is that of the finest mesh and the band three times the largest difference between neighbours.

How far off a fillet is with n elements across it shows a stepped shaft, 50 mm and 60 mm, fillet 3 mm, which the mesher makes of a crankshaft whose webs are discs about its axis. The reference is an axisymmetric computation with another program's elements, converged to 0.02 %
(\`validation/external/stepped-shaft\`):

| elements across 90° | von Mises in bending | in torsion |
|---|---|---|
| 2 | 22 % low | 8.3 % low |
| 4 | 3.9 % low | 0.15 % low |
| 6 | 1.0 % low | 0.4 % high |

The size of the elements away from the fillet does not change these. Peterson's formulas for such shafts are 4 to 7 % low in bending and 9 to 13 % low in tension themselves: they come from photoelastic measurements; a fit to finite elements by Tipton, Sorem and Rolovic is right to 0.7 % in bending.`,"theory/strength#stress-concentration":`## Stress concentration

\`\`\`formula
α_B = 2.6914 f(s,w) f(w) f(b) f(r) f(d_G) f(d_H) f_recess        bending at the pin's fillet         (49.1)
β_B = 2.7146 f(s,w) f(w) f(b) f(r) f(d_G) f(d_H) f_recess        bending at the journal's fillet     (49.2)
β_Q = 3.0128 f(s) f(w) f(b) f(r) f(d_H) f_recess                 radial force at the journal         (49.3)
α_T, β_T = 0.8 f(r,s) f(b) f(w)                                  torsion at both fillets             (49.4)
γ_B = 3 − 5.88 d_O + 34.6 d_O²    γ_T = 4 − 6 d_O + 30 d_O²      oil bore                            (49.5)
f_recess = max(1, 1 + (t_H + t_G)(1.8 + 3.2 s))
\`\`\`

*Source: [IacsM53].*

The polynomials f stand in \`crates/strength/src/factors.rs\`; the sheet prints each of them. They are different functions in each factor.

![Stress concentration factors over the fillet radius](../images/theory/stress-concentration.svg)

*Factors at web 3 of \`examples/in-line-4-crank-by-elements.toml\` with both fillets varied (\`lanchester stress rule\`).*`,"theory/flexible#modes":`## Modes

\`\`\`formula
K x = λ M x      (K + s M)⁻¹ M x = x/(λ + s)      xᵀ M x = 1      f = sqrt(λ)/2π                     (43.8)
\`\`\`

*Source: [GrimesLewisSimon1994].*

Block Lanczos with four vectors, fully orthogonalised in M. With the shift s > 0 a free body has a factor too, and its rigid motions come out with λ = 0. Every mode has its residual |K x − λ M x|/|K x| and its kind: shares of the
kinetic energy of slices across z that move along x, along y, turn about z, or move along z.

On request a second factor, K − σ M = L D Lᵀ with σ in the gap above the highest mode, counts the modes: D has as many numbers below zero as there are modes with λ below σ (Sylvester's law of inertia), which tells whether one is missing. A pivot that grows beyond a million times the largest entry of the diagonal leaves the count in doubt, and the result says so.`,"theory/scatter#what-is-told":`## What is told

Mean and standard deviation come from sums in whole steps of 2⁻⁴⁰ of the scale, kept as integers, so that no digit depends on the order in which samples come. Percentiles come from the samples themselves up to
100 000 of them (which are drawn once more at the end, not kept), else from counts in cells of a width of 2⁻⁹ of the value, with an error of at most 0.1 %. Memory does not grow with the number of samples.

**Capability** against a limit L, for a normal distribution and for any,

\`\`\`formula
Cpk = (L − mean)/(3 σ)        by percentiles  (L − median)/(P_99.865 % − median)                               (30.3)
\`\`\`

*Source: [Montgomery2009], process capability.*

A residual is a size: it cannot be negative, and where the nominal engine is balanced it is far from normal. The second number is then the one to use.

**Which tolerance to tighten first.** The first-order share of a deviation x in the variance of an output y

\`\`\`formula
S = var( mean of y given x ) / var(y)                                                                           (30.4)
\`\`\`

*Source: [Sobol2001].*

is what would vanish if x were known. The samples are sorted into cells by x; the variance of the cells' means, less what chance alone would give, is the numerator. Shares of one tolerance are the sum over its deviations.
All shares sum to 1, less what only several deviations together do: in a balanced engine, whose residual is a sum of small vectors in all directions, that can be a good part.

*What to tighten* is therefore answered by trying. The value P that 99.73 % of the engines do not exceed is found once more with the half width of one tolerance halved, all other tolerances and all draws as they were:

\`\`\`formula
gain of tolerance t  =  1 − P(half of t)/P                                                                      (30.7)
\`\`\`

*Derived here.*

The same draws mean that engine k differs from engine k in this tolerance alone, so that the difference of the two percentiles is that of the tolerance and not of chance. It takes the first 65 536 samples at most, a run for
each tolerance. Gains do not sum to anything: two tolerances halved together may gain more, or less, than one and the other.

![Share of the engines whose load does not exceed a value](../images/production.svg)

*Share of 100 000 engines whose load does not exceed a value: the in-line four \`examples/in-line-4-production.toml\` with its tolerances (\`lanchester scatter examples/in-line-4-production.toml\`).*`,"theory/sensitivity#exact-derivatives":`## Exact derivatives

Every number of the crank train is an input: masses, places and lengths of parts, directions and planes of throws, cylinders and weights, axes and phases of crankshafts and balance shafts, knuckle pins of articulated rods, the distance of the cylinders (all planes of the crank train stretch, balance shafts stay), the speed. Of one part, or of all parts of a kind together. Where an output depends on them: bores, factors on the pressures above and under the pistons and the angle by which these come later; planes of the main bearings; mass, centre and inertia of the block; places and directions of the mounts, factors on their stiffness, along one direction or all, on their loss factors and on their viscous damping.

An axis of a crankshaft takes its cylinders with it. Firing angles are no inputs: they say at which of its top dead centres a cylinder fires. What may come late is the pressure, by an ignition or by a top dead centre that was measured at a wrong angle, and that delay is one.

The engine is written once more, as point masses and rods with their momentum and energy, apart from the order coefficients and the closed forms of [Loads on the block](loads.md):

\`\`\`formula
F = −Σ m w″        M_x + i M_y = i Σ z F        w = x + i y of a mass in the plane z
M_z = (dE/dt)/Ω − dL/dt      dE/dt = Σ m Re( conj(w′) w″ ) + Σ J ψ′ ψ″      dL/dt = Σ m Im( conj(w) w″ ) + Σ J ψ″      (32.1)
\`\`\`

*Derived here from Newton's law and the balances of (5.2) and (5.3); derivatives by dual numbers, [GriewankWalther2008].*

with J what two end masses miss of a rod's inertia and ψ the direction of the rod. Positions become accelerations by differentiating them twice by time; all numbers on the way are dual numbers, a value and its derivative by one input (forward automatic differentiation). No step is
chosen, nothing is rounded but the last digits.

**A peak** is differentiated where it stands: at the angle θ* of the largest resultant the derivative by θ vanishes, so that the shift of the peak does not count,

\`\`\`formula
d/dp max over θ of |F(θ, p)| = Re( conj(F) ∂F/∂p )/|F|   at θ*                                         (32.2)
\`\`\`

*Derived here from (10.1): the derivative by θ vanishes at a peak.*

**An order** is an integral over the period, and so is its derivative,

\`\`\`formula
d f_n/dp = (1/T) ∫ ∂F/∂p e^(−inθ) dθ        d|f_n|/dp = Re( conj(f_n) df_n/dp )/|f_n|                   (32.3)
\`\`\`

*Derived here from the integral of an order.*

Not every size has one derivative. One that vanishes grows whichever way the input goes, by |df_n/dp| a unit. Of several peaks of one height the one that grows counts upwards, the one that falls least downwards. Both sides are told where they differ.`,"theory/balance-grade":`# Balance quality grades

A grade G is the speed e_per ω that the centre of mass may have, in mm/s [Iso21940, part 11]:

\`\`\`formula
e_per = G/ω        U_per = m G/ω        U_per = 9549 m G / n                                (16.1)
\`\`\`

*Source: [Iso21940], part 11.*

In the last one U_per is in g mm, m in kg, G in mm/s and n in rpm; 9549 is 30 000/π. ω is that of the highest service speed, not of the balancing run.`,"theory/bobweight#what-the-crank-can-balance":`## What the crank can balance

The first order of a piston of reciprocating mass m on a throw of radius r is half a vector that turns with the crank and half one that turns against it
([the two-sided spectrum](spectrum.md)). A weight on the crank turns with it. For the throws of one crankshaft, over the square of the speed,

\`\`\`formula
with the crank      A - f G      A = SUM p₊ exp(i a),  G = SUM m r exp(i a)     (17.1)
against it          B            B = SUM p₋ exp(-i a)                           (17.2)
\`\`\`

*Derived here from (4.3) and (4.4).*

f is the share of the reciprocating masses that is balanced beyond all rotating masses, a the angle of the throw. For the couple every term has its
z. No f changes B. The peak |A - f G| + |B| is smallest at

\`\`\`formula
f = Re( A conj(G) ) / |G|²                                                      (17.3)
\`\`\`

*Derived here from (17.1) and (17.2): the least |A − f G| over f.*

which is 1/2 for plain centred pistons. The first order swings in one plane where both parts are equal:

\`\`\`formula
|A - f G| = |B|                                                                 (17.4)
\`\`\`

*Derived here from (4.2).*

![First order forces of a V6 at several balance factors](../images/theory/primary-ellipse.svg)

*First-order force of the cylinders on one throw of the 60° V6 \`examples/v6-60.toml\` at balance factors from 0 to 100 % (\`lanchester workshop factor examples/v6-60.toml --least-peak --figure ellipse.svg\`). At 50 % the path is a circle, and its peak is least.*`,"theory/published-methods":`# Published methods

Before there were convex solvers, crankshafts were balanced by rules: choose the devices, write down one resultant, make it zero. Lanchester keeps
these rules as named methods, because their tables are a check on its loads and because engineers know them. \`balance ENGINE
--method ...\` fits one of them in place of the engine's counterweights and shafts, and prints what it leaves over, order by order and at the
peak, beside the true optimum of the same devices.

A rule cancels; it does not seek a minimum. Three things follow, and the output shows each of them. A device that cancels one resultant may leave another
(a couple, an order, the roll moment). A rule that takes \`r/l\` for the coefficient of the second order leaves the difference to the
[true coefficient](orders.md). And where the same devices can do the same with less unbalance, the rule does not know: the optimum beside it is the lightest of its kind.`,"theory/bond-graphs#causality":`## Causality

Each bond has one end that sets its effort; the other sets its flow, and the causal stroke stands there. The order is: sources; laws with
one form alone; stores in integral causality, in the order of the file; what is left. After each the junctions hand on what follows: at a
0 one bond brings the effort, at a 1 one bond brings the flow. A store that is reached from elsewhere first follows; a resistor that stays
free is the sign of an algebraic loop. Where a choice leads to a conflict that the other choice does not have, the other is taken: two levers
side by side leave a resistor only one of its two forms.

Loops are found by what sets what: variables that reach one another through laws, junctions, two-ports and signals, without a store between
them, are one loop (strongly connected, by Tarjan's procedure). The outputs of free resistors cut it first, then the first variable of what is
left.`,"theory/multibody#periodic-motion":`## Periodic motion

Over the crank angle the period is known. Newton's method on the map of one period finds the motion that returns, with a derivative by differences that is kept while each step leaves less than a twentieth of the residual; the eigenvalues of the map's derivative are its multipliers. All within the unit circle: it is stable. A load that does not depend on the speed prefers none:
one multiplier is 1. Newton needs a start near the motion: one of its steps changes the speed by a quarter at most, and where it does not come to the motion, as with a governor that the start drives to an end of its range, the motion is followed for 20 periods, then for 80 more, and Newton
starts again from there. Where that finds none, what the engine did meanwhile is told: it came to rest, or its speed went on changing.

![Speed of a generator set from its start to its stop](../images/simulated-speed.svg)

*A run at free speed: the generator set of the [guide](../guide/simulate.md) from its start to its stop (\`lanchester simulate examples/generator-set-3.toml\`).*

With a dead time of the governor the past of its command is part of the state. Over one period more than the past reaches, the state at the start alone says where the motion goes; Newton corrects what has not died out by then (singular values of the derivative above a thousandth), the rest the motion does by itself. Such
a motion has infinitely many multipliers: whether it is stable is seen by following a small departure.`};export{e as default};