"""A small rigorous solver for one-dimensional reflection gratings: Maxwell's equations, no model of the surface.

It is the reference for the front factors of the scalar model (`factors.py`). Classical mounting: the plane of
incidence is perpendicular to the grooves, so the two polarisations do not mix. Three methods, each where it converges
best:

- `coordinate`: the C-method (Chandezon): Maxwell's equations in coordinates that follow the surface. Sinusoid and
  blaze; dielectric, metal, perfect conductor. The derivative terms are products of Toeplitz matrices of the slope
  (not the matrix of the squared slope), which is what makes profiles with edges converge (Li and Chandezon 1996).
- `layered`: the rigorous coupled-wave method (RCWA) with Li's factorisation rules (1996) and a recursion of
  reflection matrices from the substrate upward, in which only decaying exponentials occur. Lamellar, and as a
  staircase any profile.
- `groove_modes`: waveguide modes in the grooves of a perfectly conducting lamellar grating, matched to the plane
  waves above.

A fourth, `rayleigh`, takes plane waves all the way down to the surface. It is right for shallow sinusoids only (slope
below 0.448) and serves to check the C-method on metals in p, where a staircase does not converge.

Conventions: time dependence exp(-i omega t), so absorbing media have n + ik with k > 0; lengths in wavelengths; k0 =
2 pi. Polarisation "s" has the electric field along the grooves, "p" the magnetic one. Order m leaves with
sin(theta_m) = sin(theta_i) + m / period; efficiencies are power fractions of the incident power.
"""

from dataclasses import dataclass, field

import numpy as np
import scipy.linalg as la

from profiles import interval_coefficients

K0 = 2 * np.pi

# Aluminium at 550 nm (after Rakic, Applied Optics 34, 4755, 1995; rounded). Dielectric: keratin. None: perfect conductor.
MATERIALS = {"aluminium": 0.96 + 6.70j, "conductor": None, "dielectric": 1.56 + 0.0j}
POLARISATIONS = ("s", "p")


@dataclass
class Efficiencies:
    """Power fractions of the propagating orders, reflected and transmitted (by order number)."""

    reflected: dict
    transmitted: dict = field(default_factory=dict)

    def total(self):
        """All power that leaves; 1 for a surface without loss."""
        return sum(self.reflected.values()) + sum(self.transmitted.values())


@dataclass(frozen=True)
class Waves:
    """Plane-wave orders -half..half above the grating and below it."""

    orders: np.ndarray
    alpha: np.ndarray  # wave number along x
    above: np.ndarray  # wave number along the normal in vacuum, Im >= 0
    below: np.ndarray | None  # the same in the solid; None for a perfect conductor


def plane_waves(period, sine, index, half):
    """The orders that the computation keeps; `half` on each side of the mirror order."""
    orders = np.arange(-half, half + 1)
    alpha = K0 * (sine + orders / period)
    above = normal_number(1.0, alpha)
    below = None if index is None else normal_number(index, alpha)
    return Waves(orders, alpha, above, below)


def normal_number(index, alpha):
    """sqrt((k0 n)^2 - alpha^2) on the branch that decays away from the surface."""
    root = np.sqrt((K0 * index) ** 2 - alpha.astype(complex) ** 2)
    return np.where(root.imag < 0, -root, root)


def solve(profile, index, theta_i_deg, polarisation, half=None, method=None, layers=60):
    """Efficiencies of all propagating orders. `half` sets the number of orders kept, `method` overrides the choice."""
    sine = np.sin(np.radians(theta_i_deg))
    if method is None:
        method = "coordinate" if profile.kind != "lamellar" else "layered" if index is not None else "groove_modes"
    if half is None:
        half = default_half(profile, method)
    if method == "coordinate":
        return coordinate(profile, index, sine, polarisation, half)
    if method == "layered":
        return layered(profile, index, sine, polarisation, half, layers)
    if method == "groove_modes":
        return groove_modes(profile, sine, polarisation, half)
    if method == "rayleigh":
        return rayleigh(profile, index, sine, polarisation, half)
    raise ValueError(f"unknown method {method}")


def default_half(profile, method):
    """Orders to keep on each side: enough that doubling moves no order by more than what the checks state."""
    if method == "coordinate":
        # More is not better for a sinusoid: its coefficients fall fast, and on steep ones rounding grows with the orders.
        return int(12 + 6 * profile.period if profile.kind == "sinusoid" else 36 + 8 * profile.period)
    if method == "layered":
        return int(45 + 20 * profile.period)
    return int(40 + 20 * profile.period)


def unpolarised(profile, index, theta_i_deg, **settings):
    """Mean of both polarisations."""
    s, p = (solve(profile, index, theta_i_deg, x, **settings) for x in POLARISATIONS)
    mean = lambda a, b: {m: 0.5 * (a[m] + b[m]) for m in a}
    return Efficiencies(mean(s.reflected, p.reflected), mean(s.transmitted, p.transmitted))


def fresnel(index, theta_i_deg):
    """Power reflectance of the flat surface, for s and p."""
    if index is None:
        return 1.0, 1.0
    cosine = np.cos(np.radians(theta_i_deg))
    inside = np.sqrt(complex(index) ** 2 - np.sin(np.radians(theta_i_deg)) ** 2)
    s = abs((cosine - inside) / (cosine + inside)) ** 2
    p = abs((index**2 * cosine - inside) / (index**2 * cosine + inside)) ** 2
    return s, p


# --- C-method ---------------------------------------------------------------------------------------------------------


def coordinate(profile, index, sine, polarisation, half):
    """The C-method. Unknowns: amplitudes of waves above and below; equations: the field and its normal derivative."""
    waves = plane_waves(profile.period, sine, index, half)
    slope = _toeplitz(profile.slope_coefficients, half)
    above, up_real = _surface_waves(profile, waves, slope, waves.above, +1)
    incident = _plane_on_surface(profile, waves, half, -waves.above[half])
    count = waves.orders.size
    if index is None:
        # The electric field (s) or the magnetic field's normal derivative (p) vanishes on the surface.
        part = 0 if polarisation == "s" else 1
        amplitudes = np.linalg.solve(above[part], -incident[part])
        return Efficiencies(_powers(waves, up_real, amplitudes, waves.above, 1.0))
    below, down_real = _surface_waves(profile, waves, slope, waves.below, -1)
    weight = 1.0 if polarisation == "s" else 1 / complex(index) ** 2
    matrix = np.block([[above[0], -below[0]], [above[1], -weight * below[1]]])
    amplitudes = np.linalg.solve(matrix, -np.concatenate(incident))
    reflected = _powers(waves, up_real, amplitudes[:count], waves.above, 1.0)
    transmitted = _powers(waves, down_real, amplitudes[count:], waves.below, weight)
    return Efficiencies(reflected, transmitted)


def _toeplitz(coefficients, half):
    """Matrix of multiplication by a function, from its Fourier coefficients."""
    first = coefficients(np.arange(0, 2 * half + 1))
    return la.toeplitz(first, coefficients(-np.arange(0, 2 * half + 1)))


def _plane_on_surface(profile, waves, n, beta):
    """Fourier coefficients on the surface of the plane wave of order index n with normal wave number beta, and of
    its derivative along the (unnormalised) normal (-h', 1)."""
    steps = waves.orders - waves.orders[n]
    value = profile.phasor(beta, steps)
    tilt = waves.alpha[n] * steps * (K0 / profile.period) / beta  # h' exp(i beta h), integrated by parts
    return value, 1j * (beta - tilt) * value


def _surface_waves(profile, waves, slope, normal, direction):
    """Waves that leave the surface upward (+1) or downward (-1): their values and normal derivatives on it.

    Propagating orders are plane waves, known in closed form: they come first, and their amplitudes are the efficiencies.
    The rest are the decaying eigenvectors of Maxwell's equations in the coordinates of the surface.
    """
    real = [n for n in range(normal.size) if abs(normal[n].imag) < 1e-9]
    plane = [_plane_on_surface(profile, waves, n, direction * normal[n]) for n in real]
    rho, vectors = _eigenwaves(waves, slope, normal)
    free = np.ones(rho.size, dtype=bool)
    for n in real:
        for sign in (1, -1):
            distance = np.where(free, np.abs(rho - sign * normal[n]), np.inf)
            free[np.argmin(distance)] = False
    chosen = np.flatnonzero(free & (direction * rho.imag > 0))
    wanted = normal.size - len(real)
    if chosen.size != wanted:
        raise ArithmeticError(f"{chosen.size} decaying waves instead of {wanted}: change the number of orders")
    rho, value = rho[chosen], vectors[:, chosen]
    along = waves.alpha[:, None] * value - slope @ (value * rho)  # the field's derivative along x, over i
    derivative = 1j * (value * rho - slope @ along)
    columns = lambda part, rest: np.column_stack([p[part] for p in plane] + [rest]) if plane else rest
    return (columns(0, value), columns(1, derivative)), real


def _eigenwaves(waves, slope, normal):
    """Eigenvalues rho and vectors F of (d/dx - h' d/du)^2 F + d^2F/du^2 + k^2 F = 0, F ~ exp(i rho u)."""
    square = (normal**2)[:, None]  # k^2 - alpha^2
    mixed = waves.alpha[:, None] * slope + slope * waves.alpha[None, :]
    identity = np.eye(normal.size)
    matrix = np.block([[-mixed / square, (identity + slope @ slope) / square], [identity, np.zeros_like(identity)]])
    values, vectors = la.eig(matrix)
    return 1 / values, vectors[: normal.size]


def rayleigh(profile, index, sine, polarisation, half):
    """Plane waves alone on both sides of the surface (Rayleigh's hypothesis). Keep few orders: it is ill-conditioned."""
    waves = plane_waves(profile.period, sine, index, half)
    count = waves.orders.size
    every = lambda normal, sign: [np.column_stack(part) for part in zip(
        *(_plane_on_surface(profile, waves, n, sign * normal[n]) for n in range(count)))]
    above, below = every(waves.above, 1), every(waves.below, -1)
    weight = 1.0 if polarisation == "s" else 1 / complex(index) ** 2
    incident = np.concatenate(_plane_on_surface(profile, waves, half, -waves.above[half]))
    matrix = np.block([[above[0], -below[0]], [above[1], -weight * below[1]]])
    amplitudes = np.linalg.solve(matrix, -incident)
    return Efficiencies(_order_powers(waves, amplitudes[:count], waves.above, 1.0),
                        _order_powers(waves, amplitudes[count:], waves.below, weight))


def _powers(waves, real, amplitudes, normal, weight):
    """Power fraction of each propagating order; the first amplitudes belong to the orders `real`."""
    start = waves.above[waves.orders.size // 2].real
    share = lambda i, n: abs(amplitudes[i]) ** 2 * (weight * normal[n]).real / start
    return {int(waves.orders[n]): float(share(i, n)) for i, n in enumerate(real)}


# --- RCWA -------------------------------------------------------------------------------------------------------------


def layered(profile, index, sine, polarisation, half, layers):
    """RCWA: the profile as a stack of lamellar layers (one for a lamellar profile)."""
    if index is None:
        raise ValueError("a perfect conductor has no permittivity: use another method")
    waves = plane_waves(profile.period, sine, index, half)
    count = 1 if profile.kind == "lamellar" else layers
    thickness = profile.depth / count
    weight = 1.0 if polarisation == "s" else 1 / complex(index) ** 2
    identity = np.eye(waves.orders.size, dtype=complex)
    # `admittance` maps the field on a plane to its (weighted) normal derivative, everything below taken into account;
    # `downward` maps it to the field at the substrate.
    admittance = np.diag(-1j * weight * waves.below)
    downward = identity
    for layer in range(count):
        middle = -profile.depth / 2 + (layer + 0.5) * thickness
        field_modes, flux_modes, rates = _layer_modes(profile, middle, index, waves, polarisation)
        right = admittance @ field_modes
        bottom = np.linalg.solve(flux_modes - right, flux_modes + right)  # up over down, at the layer's bottom
        decay = np.exp(1j * rates * thickness)
        top = decay[:, None] * bottom * decay[None, :]
        field_top = field_modes @ (identity + top)
        inverse = np.linalg.inv(field_top)
        admittance = flux_modes @ (top - identity) @ inverse
        downward = downward @ field_modes @ (identity + bottom) @ (decay[:, None] * inverse)
    start = np.zeros(waves.orders.size, dtype=complex)
    start[half] = 1.0
    vacuum = np.diag(1j * waves.above)
    reflected = np.linalg.solve(vacuum - admittance, (vacuum + admittance) @ start)
    transmitted = downward @ (start + reflected)
    return Efficiencies(*(_order_powers(waves, *x) for x in
                          ((reflected, waves.above, 1.0), (transmitted, waves.below, weight))))


def _layer_modes(profile, z, index, waves, polarisation):
    """Fields, fluxes and normal wave numbers of a layer's modes. Li's rules decide which permittivity is inverted."""
    start, end = profile.solid_interval(z)
    half = waves.orders.size // 2
    epsilon = complex(index) ** 2
    filled = lambda inside: _toeplitz(lambda m: (inside - 1) * interval_coefficients(start, end, m) + (m == 0), half)
    alpha = np.diag(waves.alpha)
    if polarisation == "s":
        square, modes = la.eig(K0**2 * filled(epsilon) - alpha @ alpha)
        outer = modes
    else:
        inverse = filled(1 / epsilon)  # its inverse serves the field normal to the walls
        matrix = K0**2 * np.eye(waves.orders.size) - alpha @ np.linalg.solve(filled(epsilon), alpha)
        square, modes = la.eig(np.linalg.solve(inverse, matrix))
        outer = inverse @ modes
    rates = np.sqrt(square.astype(complex))
    rates = np.where(rates.imag < 0, -rates, rates)
    return modes, outer * (1j * rates)[None, :], rates


def _order_powers(waves, amplitudes, normal, weight):
    """Power fractions from one amplitude per order."""
    real = [n for n in range(normal.size) if abs(normal[n].imag) < 1e-9]
    return _powers(waves, real, amplitudes[real], normal, weight)


# --- Modes of a perfectly conducting groove ---------------------------------------------------------------------------


def groove_modes(profile, sine, polarisation, half):
    """Lamellar perfect conductor: sine (s) or cosine (p) modes of the groove, matched to the plane waves at its mouth."""
    if profile.kind != "lamellar":
        raise ValueError("groove modes are those of a lamellar profile")
    waves = plane_waves(profile.period, sine, None, half)
    start, _ = profile.solid_interval(0.0)  # the groove reaches from 0 to this share of the period
    width = start * profile.period
    n = np.arange(1, max(2, int(round(2 * half * start)))) - (polarisation == "p")
    gamma = np.sqrt(complex(K0) ** 2 - (np.pi * n / width) ** 2 + 0j)
    twice = np.exp(2j * gamma * profile.depth)
    sign = -1 if polarisation == "s" else 1  # the field at the groove's bottom vanishes, or its derivative
    overlap = _overlaps(waves, n, start, profile.period, polarisation)
    norm = np.where(n == 0, start, start / 2)
    mouth, flux = 1 + sign * twice, -1j * gamma * (1 - sign * twice)
    first = np.zeros(waves.orders.size, dtype=complex)
    first[half] = 1.0
    beta = 1j * waves.above
    if polarisation == "s":
        # Field over the whole period: R = -first + overlap (a mouth). Derivative over the groove, weighed by its modes.
        matrix = overlap.conj().T @ (beta[:, None] * overlap * mouth) - np.diag(norm * flux)
        a = np.linalg.solve(matrix, 2 * overlap.conj().T @ (beta * first))
        reflected = overlap @ (a * mouth) - first
    else:
        # Derivative over the whole period: R = first + overlap (a flux) / beta. Field over the groove.
        matrix = overlap.conj().T @ (overlap * flux / beta[:, None]) - np.diag(norm * mouth)
        a = np.linalg.solve(matrix, -2 * overlap.conj().T @ first)
        reflected = first + overlap @ (a * flux) / beta
    return Efficiencies(_order_powers(waves, reflected, waves.above, 1.0))


def _overlaps(waves, n, share, period, polarisation):
    """(1/d) integral over the groove of exp(-i alpha_m x) times its mode n."""
    width = share * period

    def wave(q):  # (1/d) integral of exp(-i q x)
        x = q * width / 2
        return share * np.exp(-1j * x) * np.sinc(x / np.pi)

    plus = wave(waves.alpha[:, None] - np.pi * n[None, :] / width)
    minus = wave(waves.alpha[:, None] + np.pi * n[None, :] / width)
    return (plus - minus) / 2j if polarisation == "s" else (plus + minus) / 2
