// Light from the Moon's surface: a photometric law of one phase angle, and what it makes of sunlight and earthlight.
// Axes are the Moon's mean-Earth axes; vectors are unit vectors.

// The law's two parts. Both depend on the phase angle alone, so that a picture needs them once; the cheap law has the
// same form.
struct LunarLaw {
  Real seeliger; // of cos i / (cos i + cos e)
  Real lambert;  // of cos i
};

// Luminance is albedo / pi x illuminance of a plane that faces the light x this.
// cos_incidence: 0 to 1. cos_emission: >= 0. Where both are 0 the law has no limit, and no light falls.
FN Real lunar_reflectance(Real cos_incidence, Real cos_emission, LunarLaw law) {
  return cos_incidence * (law.seeliger / max(cos_incidence + cos_emission, Real(1.0e-7)) + law.lambert);
}

// Light of a Lommel-Seeliger sphere against that at full phase: 1 at 0, 0 at pi. phase_rad: 0 to 3.1.
FN Real seeliger_sphere(Real phase_rad) {
  Real h = Real(0.5) * phase_rad;
  return Real(1.0) + sin(h) * tan(h) * log(max(tan(Real(0.5) * h), Real(1.0e-20)));
}

// The same of a Lambert sphere. phase_rad: 0 to pi, with its limit at pi.
FN Real lambert_sphere(Real phase_rad) {
  Real e = pi - phase_rad;
  Real whole = sin(e) - e * cos(e);
  return (e < Real(0.1) ? e * e * e * (Real(1.0) - Real(0.1) * e * e) / Real(3.0) : whole) / pi;
}

// Beyond this phase angle, where hardly anything has been measured, the surface's law stays what it is there.
CONSTANT Real lunar_law_end_deg = Real(150.0);

// Share of the lunar-Lambert law's first part: McEwen 1991 (Icarus 92, 298), from 1 at full Moon, whose disc is flat,
// to 0 at 104 degrees and beyond, where the terminator fades.
FN Real lunar_lambert_share(Real phase_deg) {
  Real a = min(phase_deg, Real(110.0));
  return max(Real(1.0) + a * (Real(-0.019) + a * (Real(2.42e-4) + a * Real(-1.46e-6))), Real(0.0));
}

// The opposition surge in magnitudes: 0.31 at full Moon, 0.25 less at 4 degrees. Clementine saw the Moon gain more than
// 40 % from 4 degrees to 0 (Buratti, Hillier and Wang 1996, Icarus 124, 490), the law below without surge 10 % of it;
// the lunar irradiance model of Kieffer and Stone 2005 (AJ 129, 2887) has 0.32 from 7 degrees to 0.
FN Real lunar_surge_mag(Real phase_deg) { return Real(0.31) * exp(phase_deg / Real(-2.5)); }

// What a sphere of albedo 1 with the law of one phase angle, without its gain, gives of that at full Moon.
FN Real lunar_lambert_sphere(Real phase_deg) {
  Real share = lunar_lambert_share(phase_deg);
  Real phase_rad = phase_deg * (pi / Real(180.0));
  Real light = (Real(1.0) - share) * (Real(2.0) / Real(3.0)) * lambert_sphere(phase_rad);
  return share > Real(0.0) ? light + share * seeliger_sphere(phase_rad) : light;
}

// The whole Moon's light against that at full Moon without the surge. To 150 degrees
// -2.5 log10 is 0.026 a + 4e-9 a^4 (Krisciunas and Schaefer 1991, PASP 103, 1033, eq. 9) less the surge.
FN Real lunar_measured_phase(Real phase_deg) {
  Real square = phase_deg * phase_deg;
  Real magnitude = Real(0.026) * phase_deg + Real(4.0e-9) * square * square - lunar_surge_mag(phase_deg);
  return exp(Real(-0.921034037197618) * magnitude);
}
FN Real lunar_phase(Real phase_deg) {
  if (phase_deg <= lunar_law_end_deg) {
    return lunar_measured_phase(phase_deg);
  }
  return lunar_measured_phase(lunar_law_end_deg) * lunar_lambert_sphere(phase_deg) /
         lunar_lambert_sphere(lunar_law_end_deg);
}

// The default law: McEwen's lunar-Lambert with the gain by which a smooth sphere of one albedo has the measured light.
// phase_deg: 0 to 180.
FN LunarLaw lunar_law(Real phase_deg) {
  Real at = min(phase_deg, lunar_law_end_deg);
  Real gain = lunar_measured_phase(at) / lunar_lambert_sphere(at);
  Real share = lunar_lambert_share(at);
  LunarLaw law;
  law.seeliger = Real(2.0) * share * gain;
  law.lambert = (Real(1.0) - share) * gain;
  return law;
}

// Hapke 1963 and Jensen et al. 2001: backward gain B with g = 0.6. 2 at phase 0, 1 from pi/2. Written with
// q = (1 - exp(-x)) / x, x = g / tan(phase), whose limits are plain.
FN Real lunar_retrodirection(Real phase_rad) {
  Real x = Real(0.6) * cos(phase_rad) / max(sin(phase_rad), Real(1.0e-6));
  if (x <= Real(0.0)) {
    return Real(1.0);
  }
  Real q = x < Real(0.03) ? Real(1.0) - x * (Real(0.5) - x / Real(6.0)) : (Real(1.0) - exp(-x)) / x;
  return Real(2.0) - Real(0.5) * q * (Real(2.0) + x * q);
}

// The same authors' mean scattering S of a grain, with t = 0.1.
FN Real lunar_grain_scattering(Real phase_rad) {
  Real c = cos(phase_rad);
  Real forward = Real(1.0) - Real(0.5) * c;
  return (sin(phase_rad) + (pi - phase_rad) * c) / pi + Real(0.1) * forward * forward;
}

// The cheap law: Hapke, Lommel and Seeliger's, 2/3 B S cos i / (cos i + cos e), which gives the luminance; as a BRDF,
// to be multiplied by cos i again, the full Moon would not be flat.
FN LunarLaw cheap_lunar_law(Real phase_deg) {
  Real phase_rad = phase_deg * (pi / Real(180.0));
  LunarLaw law;
  law.seeliger = Real(2.0) / Real(3.0) * lunar_retrodirection(phase_rad) * lunar_grain_scattering(phase_rad);
  law.lambert = Real(0.0);
  return law;
}

// Mean of max(cosine, 0) over a disc of light as wide as the Sun: exact for one that darkens to its limb as the cosine
// there, within 0.03 radii of it for a uniform one.
FN Real cosine_to_disc(Real cosine, Real radius_rad) {
  Real r = max(radius_rad, Real(1.0e-7));
  Real x = clamp(cosine / r, Real(-1.0), Real(1.0));
  Real rise = Real(1.0) + x;
  return max(cosine - r, Real(0.0)) + r * rise * rise * rise * (Real(3.0) - x) / Real(16.0);
}

// Sine of the depth below the sphere's own horizon from which the highest relief is still lit: mountains 3 km above
// their surroundings reach 3.4 degrees beyond the terminator.
CONSTANT Real lunar_relief_reach = Real(0.06);

// The surface that is seen at a place, not normalised: near the limb what turns away hides behind what does not, so
// that it is brought back to half the sphere's own cosine.
FN vec3 lunar_relief_seen(vec3 sphere_normal, vec3 relief_normal, vec3 to_observer) {
  Real lack = Real(0.5) * dot(sphere_normal, to_observer) - dot(relief_normal, to_observer);
  return relief_normal + max(lack, Real(0.0)) * to_observer;
}

// Reflectance of a place with relief for light from one direction. Relief shades the day side and lights what rises
// beyond the terminator, but not the night.
FN Real lunar_relief_reflectance(vec3 sphere_normal, vec3 relief_normal, vec3 to_observer, vec3 to_light,
                                 Real light_radius_rad, LunarLaw law) {
  Real above_horizon = clamp(Real(1.0) + dot(sphere_normal, to_light) / lunar_relief_reach, Real(0.0), Real(1.0));
  vec3 seen = lunar_relief_seen(sphere_normal, relief_normal, to_observer);
  Real cos_incidence = above_horizon * cosine_to_disc(dot(seen, to_light), light_radius_rad);
  return lunar_reflectance(cos_incidence, max(dot(seen, to_observer), Real(0.0)), law);
}

// What one picture's Moon is lit by. C++ fills it (vesper::MoonDisc).
struct MoonLighting {
  vec3 to_sun;
  vec3 to_earth;
  vec4 sunlit;         // X, Y, Z, S in lux on a plane that faces the Sun, in the colour that the Moon gives sunlight
  vec4 earthlit;       // the same of earthlight
  LunarLaw sun_law;
  LunarLaw earth_law;
  Real sun_radius_rad; // as seen from the Moon
};

CONSTANT Real earth_radius_from_moon_rad = Real(0.0166);

// Luminance X, Y, Z, S in cd/m2 of a place by the Sun and by the Earth.
// albedo: the map's (1 for a Lambert plane at normal incidence). eclipse_xyzs: shares of sunlight that the Earth leaves.
FN vec4 moon_sunlight(Real albedo, vec3 sphere_normal, vec3 relief_normal, vec3 to_observer, MoonLighting lighting,
                      vec4 eclipse_xyzs) {
  return albedo / pi *
         lunar_relief_reflectance(sphere_normal, relief_normal, to_observer, lighting.to_sun, lighting.sun_radius_rad,
                                  lighting.sun_law) *
         lighting.sunlit * eclipse_xyzs;
}
FN vec4 moon_earthlight(Real albedo, vec3 sphere_normal, vec3 relief_normal, vec3 to_observer, MoonLighting lighting) {
  return albedo / pi *
         lunar_relief_reflectance(sphere_normal, relief_normal, to_observer, lighting.to_earth,
                                  earth_radius_from_moon_rad, lighting.earth_law) *
         lighting.earthlit;
}

// Both.
FN vec4 moon_luminance(Real albedo, vec3 sphere_normal, vec3 relief_normal, vec3 to_observer, MoonLighting lighting,
                       vec4 eclipse_xyzs) {
  return moon_sunlight(albedo, sphere_normal, relief_normal, to_observer, lighting, eclipse_xyzs) +
         moon_earthlight(albedo, sphere_normal, relief_normal, to_observer, lighting);
}
