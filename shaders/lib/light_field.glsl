// Light scattered in the air under a distant light: what a step of a ray sends toward the ray's origin, and what the
// light of all directions amounts to at a node. For four wavelengths at a time (Light), in 1/sr above an irradiance of 1.
//
// The field stands at nodes by height and by the light's zenith angle. What molecules scatter needs no more of the
// radiance around a place than its mean and second moments: with them Rayleigh's phase function is exact. What aerosol
// scatters is kept by direction. Means and sources are logarithms to base 2, between which light that falls
// exponentially is linear. Axes of a place: z to its zenith, x to the light's azimuth.

CONSTANT int field_moments = 4; // log2 of the mean radiance; means of xx, zz, xz, weighted by radiance

// Directions of aerosol's sources: zenith nodes crowd at the horizon, azimuth nodes at the light.
CONSTANT int source_zeniths = 15;
CONSTANT int source_azimuths = 7;

CONSTANT int light_angle_cells = 2048; // of the table that finds the node of a light's zenith angle

// The table of optical depths toward a light, log2: of rays that rise, by the square root of the height and evenly with
// the distance to the top; behind them of level rays, by the square root of the height.
CONSTANT int depth_heights = 128;
CONSTANT int depth_angles = 96;
CONSTANT int depth_levels = 512;

struct LightShell {
  Real ground_km;
  Real top_km;
  int angles; // nodes of the light's zenith angle
};

// A step of a ray, wherever the light stands.
struct LightStep {
  // Cosine of the light's zenith angle there = from_vertical * cos(that at the ray's origin)
  //                                          + from_level * sin(the same) * cos(azimuth from the light).
  Real from_vertical;
  Real from_level;
  Real view_z; // cosine of the ray's zenith angle there
  Real height_km;
  Real height_place; // among the field's nodes
  Real zenith_place; // of the ray among the nodes of aerosol's sources; negative where no aerosol counts
  Real depth_place;  // of the height in the table of optical depths
  Real unused;
};

// Where the light stands for a ray, at the ray's origin.
struct LightPlace {
  Real vertical;  // cosine of its zenith angle
  Real level;     // sine of it, times the cosine of the azimuth between ray and light
  Real cos_angle; // between ray and light
};

FN Real light_cosine(LightStep at, LightPlace light) {
  return clamp(at.from_vertical * light.vertical + at.from_level * light.level, Real(-1.0), Real(1.0));
}

// Place of a light's zenith angle among the nodes.
FN Real light_angle_place(Real cosine, RealTable places) {
  Real cell = (Real(1.0) - cosine) * (Real(0.5) * Real(light_angle_cells));
  int i = min(int(cell), light_angle_cells - 1);
  Real low = fetch_real(places, i);
  return low + (cell - Real(i)) * (fetch_real(places, i + 1) - low);
}

// Light straight from the source ------------------------------------------------------------------------------------

// Share of the light's disc, of that angular radius, that stands above the horizon of a place.
FN Real visible_light(Real cosine, Real height_km, Real ground_km, Real radius_rad) {
  Real radius_km = ground_km + height_km;
  Real sin_dip = sqrt(height_km * (Real(2.0) * ground_km + height_km)) / radius_km;
  Real cos_dip = ground_km / radius_km;
  // Sine of the altitude above the horizon.
  Real above = cosine * cos_dip + sqrt(max((Real(1.0) - cosine) * (Real(1.0) + cosine), Real(0.0))) * sin_dip;
  if (abs(above) >= sin(radius_rad)) {
    return above > Real(0.0) ? Real(1.0) : Real(0.0);
  }
  Real share = clamp(asin(above) / radius_rad, Real(-1.0), Real(1.0));
  return Real(0.5) + (share * sqrt(max(Real(1.0) - share * share, Real(0.0))) + asin(share)) / pi;
}

struct DepthPlace {
  int cell; // of a ray that rises: lower height, first angle
  Real low; // weight of the lower height
  Real left;
  int level; // of a level ray, at the lowest place of one that falls first; negative for others
  Real below;
};

// A light below the horizon is taken at it.
FN DepthPlace depth_place(LightStep at, Real cosine, LightShell shell) {
  Real radius_km = shell.ground_km + at.height_km;
  // Not from the radii, whose rounding may put the place above the top.
  Real nearest = max(shell.top_km - shell.ground_km - at.height_km, Real(0.0));
  Real reach2 = nearest * (shell.top_km + radius_km);
  Real along = radius_km * abs(cosine);
  Real distance = reach2 / max(along + sqrt(along * along + reach2), Real(1.0e-6));
  Real share = (distance - nearest) / max(sqrt(reach2) - nearest, Real(1.0e-6));
  Real column = clamp(share, Real(0.0), Real(1.0)) * Real(depth_angles - 1);
  int i = min(int(at.depth_place), depth_heights - 2);
  int j = min(int(column), depth_angles - 2);
  DepthPlace result;
  result.cell = i * depth_angles + j;
  result.low = Real(i + 1) - at.depth_place;
  result.left = Real(j + 1) - column;
  result.level = -1;
  if (cosine < Real(0.0)) {
    Real descent = along * abs(cosine) / (Real(1.0) + sqrt(max((Real(1.0) - cosine) * (Real(1.0) + cosine), Real(0.0))));
    Real least = max(at.height_km - descent, Real(0.0)) / (shell.top_km - shell.ground_km);
    Real place = sqrt(min(least, Real(1.0))) * Real(depth_levels - 1);
    result.level = min(int(place), depth_levels - 2);
    result.below = Real(result.level + 1) - place;
  }
  return result;
}

FN Light light_transmittance(DepthPlace at, LightTable depths) {
  Light low = at.left * fetch_light(depths, at.cell) + (Real(1.0) - at.left) * fetch_light(depths, at.cell + 1);
  int above = at.cell + depth_angles;
  Light high = at.left * fetch_light(depths, above) + (Real(1.0) - at.left) * fetch_light(depths, above + 1);
  Light rising = at.low * low + (Real(1.0) - at.low) * high;
  if (at.level < 0) {
    return exp2(-rising);
  }
  // As much behind the lowest place as a level ray from there, and the same before, but for what lies behind the ray's
  // origin.
  int level = depth_heights * depth_angles + at.level;
  Light half_way = at.below * fetch_light(depths, level) + (Real(1.0) - at.below) * fetch_light(depths, level + 1);
  return exp2(min(rising - Real(2.0) * half_way, Light(0.0)));
}

// Light scattered before ---------------------------------------------------------------------------------------------

// A step among the field's nodes.
struct FieldPlace {
  int node;   // of the lower height and the first angle
  Real w00;   // weights of the nodes: lower height, first angle
  Real w01;   // lower height, second angle
  Real w10;
  Real w11;
  Real vx; // the ray's direction
  Real vz;
  int source; // first of aerosol's directions; negative where no aerosol counts
  Real s00;   // weights of the directions: lower zenith, first azimuth
  Real s01;
  Real s10;
  Real s11;
};

FN FieldPlace field_place(LightStep at, Real cosine, LightPlace light, LightShell shell, RealTable places) {
  FieldPlace result;
  Real angle = light_angle_place(cosine, places);
  int i = int(at.height_place);
  int j = min(int(angle), shell.angles - 2);
  Real s = at.height_place - Real(i);
  Real t = angle - Real(j);
  result.node = i * shell.angles + j;
  result.w00 = (Real(1.0) - s) * (Real(1.0) - t);
  result.w01 = (Real(1.0) - s) * t;
  result.w10 = s * (Real(1.0) - t);
  result.w11 = s * t;
  Real light_x = sqrt((Real(1.0) - cosine) * (Real(1.0) + cosine));
  Real level = sqrt(max((Real(1.0) - at.view_z) * (Real(1.0) + at.view_z), Real(0.0)));
  Real cos_azimuth =
      clamp((light.cos_angle - cosine * at.view_z) / max(light_x * level, Real(1.0e-6)), Real(-1.0), Real(1.0));
  result.vx = level * cos_azimuth;
  result.vz = at.view_z;
  result.source = -1;
  if (at.zenith_place >= Real(0.0)) {
    // Half the sine of half the azimuth is even at the light and away from it.
    Real azimuth = Real(source_azimuths - 1) * sqrt(Real(0.5) - Real(0.5) * cos_azimuth);
    int a = min(int(azimuth), source_azimuths - 2);
    int e = min(int(at.zenith_place), source_zeniths - 2);
    Real q = azimuth - Real(a);
    Real p = at.zenith_place - Real(e);
    result.source = e * source_azimuths + a;
    result.s00 = (Real(1.0) - p) * (Real(1.0) - q);
    result.s01 = (Real(1.0) - p) * q;
    result.s10 = p * (Real(1.0) - q);
    result.s11 = p * q;
  }
  return result;
}

FN Light moment_between(FieldPlace at, int moment, LightTable field, int angles) {
  int low = at.node * field_moments + moment;
  int high = low + angles * field_moments;
  return at.w00 * fetch_light(field, low) + at.w01 * fetch_light(field, low + field_moments) +
         at.w10 * fetch_light(field, high) + at.w11 * fetch_light(field, high + field_moments);
}

// What molecules scatter into the ray. second_moment: Legendre's of their phase function, (1 + 5 m P2(cos)) / 4 pi.
FN Light scattered_by_molecules(FieldPlace at, Light second_moment, LightTable field, int angles) {
  Light xx = moment_between(at, 1, field, angles);
  Light zz = moment_between(at, 2, field, angles);
  Light xz = moment_between(at, 3, field, angles);
  Real vxx = at.vx * at.vx;
  Real vzz = at.vz * at.vz;
  Real vyy = max(Real(1.0) - vxx - vzz, Real(0.0));
  Light second = vyy + (vxx - vyy) * xx + (vzz - vyy) * zz + Real(2.0) * at.vx * at.vz * xz;
  return exp2(moment_between(at, 0, field, angles)) * (Real(1.0) + second_moment * (Real(7.5) * second - Real(2.5)));
}

FN Light source_between(FieldPlace at, int source, LightTable sources) {
  return at.s00 * fetch_light(sources, source) + at.s01 * fetch_light(sources, source + 1) +
         at.s10 * fetch_light(sources, source + source_azimuths) +
         at.s11 * fetch_light(sources, source + source_azimuths + 1);
}

// What aerosol scatters into the ray.
FN Light scattered_by_aerosol(FieldPlace at, LightTable sources, int angles) {
  int node_sources = source_zeniths * source_azimuths;
  int low = at.node * node_sources + at.source;
  int high = low + angles * node_sources;
  return exp2(at.w00 * source_between(at, low, sources) + at.w01 * source_between(at, low + node_sources, sources) +
              at.w10 * source_between(at, high, sources) + at.w11 * source_between(at, high + node_sources, sources));
}

// Irradiance of level ground.
FN Light ground_light(Real cosine, LightTable ground, RealTable places, int angles) {
  Real angle = light_angle_place(cosine, places);
  int j = min(int(angle), angles - 2);
  return exp2((Real(j + 1) - angle) * fetch_light(ground, j) + (angle - Real(j)) * fetch_light(ground, j + 1));
}

// What the light of all directions amounts to ------------------------------------------------------------------------

// A direction that light comes from at a node, of the half with y > 0.
struct LightDirection {
  Real x;
  Real z;
  Real share; // of all directions, 1 in sum
  Real cos_azimuth;
};

// Plain sums: of mean radiance, its products and the irradiance of level ground over 4 pi.
struct LightSums {
  Light all;
  Light xx;
  Light zz;
  Light xz;
  Light level;
};

FN void add_light(Light radiance, LightDirection from, INOUT(LightSums) sums) {
  Light light = from.share * radiance;
  sums.all += light;
  sums.xx += from.x * from.x * light;
  sums.zz += from.z * from.z * light;
  sums.xz += from.x * from.z * light;
  sums.level += max(from.z, Real(0.0)) * light;
}
