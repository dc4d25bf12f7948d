#!/usr/bin/env python3
"""Gains of the regulator lqr:  dynamics/regulators/lqr_gains.py > dynamics/regulators/lqr_gains.h

For each chain of integrators x1' = x2, x2' = x3, ... xn' = u, with state weights q and input weight r
(diagonal: one over the square of what counts as much as one unit of the cost), the stabilising
solution P of  A'P + P A - P B B'P / r + Q = 0  by Newton's iteration (Kleinman 1968,
doi 10.1109/TAC.1968.1098829), and K = B'P / r. Plain Python: nothing to install.
"""

# name, what one unit of cost is worth: states, input
PROBLEMS = [
    ("corrected", "velocity 1 m/s, acceleration 2.5 m/s^2, jerk 25 m/s^3; 200 m/s^4",
     [1, 2.5, 25], 200),
    ("printed", "velocity 1 m/s, acceleration 2.5 m/s^2, jerk 20 m/s^3; 120 m/s^4",
     [1, 2.5, 20], 120),
    ("height", "height 0.5 m, climb 1.35 m/s; 4.5 m/s^2", [0.5, 1.35], 4.5),
    ("yaw", "heading 0.5 rad, yaw rate 0.67 rad/s; 1.125 rad/s^2", [0.5, 0.67], 1.125),
]


def solve(a, b):
    """x of a x = b, Gauss with pivots."""
    n = len(b)
    rows = [list(row) + [value] for row, value in zip(a, b)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(n):
            if k != i:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [x - factor * y for x, y in zip(rows[k], rows[i])]
    return [rows[i][n] / rows[i][i] for i in range(n)]


def lyapunov(a, q):
    """P of a'P + P a + q = 0."""
    n = len(a)
    system = [[0.0] * (n * n) for _ in range(n * n)]
    for i in range(n):
        for j in range(n):
            for k in range(n):
                system[i * n + j][k * n + j] += a[k][i]
                system[i * n + j][i * n + k] += a[k][j]
    flat = solve(system, [-q[i][j] for i in range(n) for j in range(n)])
    return [flat[i * n:(i + 1) * n] for i in range(n)]


def gains(worth, input_worth):
    """K and P. Newton's iteration starts from a gain that stabilises: poles at -1."""
    n = len(worth)
    q = [1 / w ** 2 for w in worth]
    r = 1 / input_worth ** 2
    k = {2: [1.0, 2.0], 3: [1.0, 3.0, 3.0]}[n]
    for _ in range(100):
        a = [[float(j == i + 1) for j in range(n)] for i in range(n)]
        a[n - 1] = [-value for value in k]
        cost = [[q[i] * (i == j) + r * k[i] * k[j] for j in range(n)] for i in range(n)]
        p = lyapunov(a, cost)
        k = [value / r for value in p[n - 1]]
    return k, p


def main():
    print("#pragma once\n")
    print("// Printed by dynamics/regulators/lqr_gains.py, which says how. Not written by hand.\n")
    print("#include <array>\n#include <cstddef>\n")
    print("namespace voronaut::lqr_gains {\n")
    print("// Of a chain of N integrators: what one unit of the cost is worth in each state and in the")
    print("// input; the gain K; the cost matrix P, row by row.")
    print("template <int N>")
    print("struct Solution {")
    print("  std::array<double, N> state_worth;\n  double input_worth;")
    print("  std::array<double, N> k;\n  std::array<double, std::size_t{N} * N> p;\n};\n")
    print("// clang-format off")
    for name, about, worth, input_worth in PROBLEMS:
        k, p = gains(worth, input_worth)
        row = lambda values: "{" + ", ".join("%.12g" % value for value in values) + "}"
        print("// %s" % about)
        print("inline constexpr Solution<%d> k%s = {" % (len(k), name.capitalize()))
        print("    .state_worth = %s,\n    .input_worth = %g," % (row(worth), input_worth))
        print("    .k = %s," % row(k))
        rows = [", ".join("%.12g" % value for value in r) for r in p]
        print("    .p = {%s}};\n" % (",\n          ".join(rows)))
    print("// clang-format on\n")
    print("}  // namespace voronaut::lqr_gains")


main()
