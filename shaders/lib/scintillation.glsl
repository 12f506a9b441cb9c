// Scintillation of point sources.
//
// The default model: log-normal intensity with the variance that turbulence theory gives for a pupil smaller than the
// Fresnel zone, as a sum of ripples with fixed frequencies, so that it is a smooth function of time, the same for a
// given star, seed and instant on any machine, and can be averaged over an exposure exactly.

CONSTANT int scintillation_ripples = 16;
CONSTANT Real scintillation_frequency_unit = Real(3.0517578125e-5); // 2^-15 Hz

// Integral of C_n^2(h) h^(5/6) dh, m^(7/6), of the Hufnagel-Valley profile with an upper wind of 14 m/s and a ground
// term of 1.7e-14 m^(-2/3): the zenith then scintillates by 0.38 rms at 555 nm, inside the range 0.2 to 0.4 that
// observers give for a pupil of 7 mm.
CONSTANT Real turbulence_moment = Real(3.77e-10);
// Height of that moment's centre and wind there; they set the ripples' frequencies and the colours' separation.
CONSTANT Real turbulence_height_m = Real(5500.0);
CONSTANT Real turbulence_wind_m_s = Real(14.0);

// Wavelengths that stand for X, Y, Z and S, metres.
FN vec4 scintillation_wavelengths() { return vec4(Real(600.0e-9), Real(555.0e-9), Real(450.0e-9), Real(507.0e-9)); }

// Rytov variance of log intensity for a plane wave (Dravins et al. 1997, PASP 109, 173; the small-aperture law,
// wavelength^(-7/6) sec(z)^(11/6)), wavelength in metres, averaged over a pupil of the given diameter in metres
// (Andrews and Phillips 2005, the factor of a plane wave).
FN Real rytov_variance(Real wavelength, Real sec_z, Real pupil) {
  Real size = Real(0.5) * pi * pupil * pupil / (wavelength * turbulence_height_m * sec_z);
  Real averaging = pow(Real(1.0) + Real(1.062) * size, Real(-7.0 / 6.0));
  return Real(19.12) * pow(wavelength, Real(-7.0 / 6.0)) * turbulence_moment * pow(sec_z, Real(11.0 / 6.0)) *
         averaging;
}

// Variance of relative intensity from weak to saturated turbulence (Andrews and Phillips 2005, plane wave without
// inner scale).
FN Real scintillation_index(Real rytov) {
  Real r = pow(rytov, Real(1.2));
  Real large = Real(0.49) * rytov / pow(Real(1.0) + Real(1.11) * r, Real(7.0 / 6.0));
  Real small = Real(0.51) * rytov / pow(Real(1.0) + Real(0.69) * r, Real(5.0 / 6.0));
  return exp(large + small) - Real(1.0);
}

// Secant of the zenith distance, bounded as the optical path is: the slant through a spherical shell.
FN Real scintillation_secant(Real sin_altitude) {
  return shell_path(abs(sin_altitude), earth_radius_km);
}

// The pupil that averages a point's scintillation as the eye's does a disc's: rays from the disc to the pupil cross the
// turbulence over a patch as wide as the disc at its distance, so widths add as independent averages. A planet of 10
// arcsec then twinkles a tenth as much as a star.
FN Real disc_pupil(Real pupil, Real disc_rad, Real sin_altitude) {
  Real patch_m = disc_rad * turbulence_height_m * scintillation_secant(sin_altitude);
  return sqrt(pupil * pupil + patch_m * patch_m);
}

// Temporal power per unit of log frequency: flat to the corner of the Fresnel zone's crossing, then f^(-8/3).
FN Real scintillation_power(Real frequency_hz, Real corner_hz) {
  return frequency_hz / (Real(1.0) + pow(frequency_hz / corner_hz, Real(8.0 / 3.0)));
}

FN Real unnormalised_sinc(Real x) { return abs(x) > Real(1.0e-3) ? sin(x) / x : Real(1.0) - x * x / Real(6.0); }

// ln I0(a) to a^8, good to 1e-3 for a up to 1.6: the exact log mean of one ripple.
FN Real log_bessel_i0(Real a) {
  Real s = Real(0.25) * a * a;
  return s * (Real(1.0) - s * (Real(0.25) - s * (Real(1.0 / 9.0) - s * Real(11.0 / 192.0))));
}

// Relative intensity in X, Y, Z, S of a point source; mean 1 over time for each.
//
// key: the star's number and the seed, hashed; seconds: the clock; exposure_s: the time averaged over (the eye's 0.1 s
// or a camera's), >= 0; pupil in metres. Colours part as their beams do: separated by dispersion at the height of the
// turbulence they cross the ripples at different phases, the more so the lower the star.
FN vec4 scintillation(uint key, PReal seconds, Real sin_altitude, Real exposure_s, Real pupil) {
  Real sec_z = scintillation_secant(sin_altitude);
  vec4 wavelength = scintillation_wavelengths();
  vec4 log_sigma = vec4(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  vec4 beam = vec4(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  // Offset of the beam from that of 555 nm at the turbulence's height: dispersion of air (n - 1 times 1e6, dry air
  // at 15 C: 276.9, 277.8, 280.8, 278.9), times tan z sec z, times the height weighted by the air below it.
  vec4 refractivity = vec4(Real(276.9e-6), Real(277.8e-6), Real(280.8e-6), Real(278.9e-6));
  Real below = Real(1000.0) * air_scale_height_km;
  Real lever = turbulence_height_m - below * (Real(1.0) - exp(-turbulence_height_m / below));
  Real tan_sec = sec_z * sqrt(max(sec_z * sec_z - Real(1.0), Real(0.0)));
  for (int c = 0; c < 4; ++c) {
    log_sigma[c] = sqrt(log(Real(1.0) + scintillation_index(rytov_variance(wavelength[c], sec_z, pupil))));
    beam[c] = (refractivity[c] - refractivity.y) * lever * tan_sec;
  }
  Real corner = turbulence_wind_m_s / sqrt(Real(2.0) * pi * wavelength.y * turbulence_height_m * sec_z);

  // Ripples at fixed log-spaced frequencies from 0.4 to 460 Hz (each a little off, by star), so that their phases do
  // not drift as the star's altitude changes; the altitude only shifts the power among them. Frequencies are whole
  // multiples of 2^-15 Hz, so that every machine gets the same phase at any date.
  Real total = Real(0.0);
  Real total_of_squares = Real(0.0);
  uint band = 13107u;
  for (int k = 0; k < scintillation_ripples; ++k) {
    Real power = scintillation_power(Real(band) * scintillation_frequency_unit, corner);
    total += power;
    total_of_squares += power * power;
    band = band / 5u * 8u;
  }
  // A finite number of ripples is a little less than log-normal: its intensity's variance lacks 7/8 sigma^4 times the
  // sum of the squared shares, to leading order.
  Real lack = Real(0.875) * total_of_squares / (total * total);
  for (int c = 0; c < 4; ++c) {
    log_sigma[c] *= sqrt(Real(1.0) + lack * log_sigma[c] * log_sigma[c]);
  }
  vec4 log_intensity = vec4(Real(0.0), Real(0.0), Real(0.0), Real(0.0));
  band = 13107u;
  for (int k = 0; k < scintillation_ripples; ++k) {
    uint ripple = hash_pair(key, uint(k));
    uint tenth = band / 10u;
    uint number = band - tenth + ripple % (2u * tenth);
    Real own = Real(number) * scintillation_frequency_unit;
    Real start = hash_unit(hash_uint(ripple + 1u));
    // Direction of the ripple's wave vector against the wind, within 60 degrees of it.
    Real heading = tan((Real(2.0) * hash_unit(hash_uint(ripple + 2u)) - Real(1.0)) * pi / Real(3.0));
    Real phase = Real(fract(PReal(number) * PReal(scintillation_frequency_unit) * seconds)) + start;
    Real amplitude = sqrt(Real(2.0) * scintillation_power(Real(band) * scintillation_frequency_unit, corner) / total) *
                     unnormalised_sinc(pi * own * exposure_s);
    Real shift = own / turbulence_wind_m_s * heading;
    for (int c = 0; c < 4; ++c) {
      Real a = amplitude * log_sigma[c];
      log_intensity[c] += a * cos(Real(2.0) * pi * (phase + shift * beam[c])) - log_bessel_i0(a);
    }
    band = band / 5u * 8u;
  }
  return exp(log_intensity);
}

// Mueller et al. 2012, sec. 4.3.2 (cheap tier): a new random number each frame, remapped by N = 0.02/n, dims the star
// by c_s beta_r Phi N, with c_s = 20, Phi the path through the homogeneous shell over the Earth's radius, and
// beta_r = (0.16, 0.37, 0.91) for red, green and blue; S takes the mean of green and blue.
FN vec4 mueller_scintillation(uint key, uint frame, Real path) {
  Real n = hash_unit(hash_pair(key, frame));
  Real remapped = min(Real(0.02) / max(n, Real(1.0e-6)), Real(1.0));
  Real strength = Real(20.0) * path * air_scale_height_km / earth_radius_km * remapped;
  return max(vec4(Real(1.0) - strength * Real(0.16), Real(1.0) - strength * Real(0.37),
                  Real(1.0) - strength * Real(0.91), Real(1.0) - strength * Real(0.64)),
             vec4(Real(0.0), Real(0.0), Real(0.0), Real(0.0)));
}
