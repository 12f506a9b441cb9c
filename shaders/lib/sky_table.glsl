// Light scattered in the air, looked up: for any observer's height, view and place of the light.
//
// The table holds logarithms to base 2 of the mean source along the view ray: the scattered light that arrives, in X, Y,
// Z and S, over the share of light that the ray's path would take in plain air (`sky_path_share`). That mean has no zeros
// where the path is short or thin, at the ground and at the top of the air, and falls and rises gently over the horizon.
// Texels: x azimuth of the view from the light, then the light's altitude; y view, first the rays that meet the ground;
// z height.

struct SkyTableFrame {
  Real ground_km; // radii
  Real top_km;
  int heights;     // nodes, at least 2 of each
  int views_below; // rays that meet the ground
  int views_above;
  int lights;
};

CONSTANT int sky_azimuths = 8; // nodes over half a turn, at equal steps

// Angle whose sine is given. GLSL's own may be off by 1e-4, which is much of a twilight's slope.
FN Real sky_arc_sine(Real sine) { return atan(sine, sqrt(max((Real(1.0) - sine) * (Real(1.0) + sine), Real(0.0)))); }

// Geometric dip of the horizon.
FN Real sky_dip(Real height_km, SkyTableFrame frame) {
  Real h = max(height_km, Real(0.0));
  return atan(sqrt(h * (Real(2.0) * frame.ground_km + h)), frame.ground_km);
}

// The same of the top of the air, for an observer above it: where the limb ends.
FN Real sky_limb_dip(Real height_km, SkyTableFrame frame) {
  Real h = max(height_km - (frame.top_km - frame.ground_km), Real(0.0));
  return atan(sqrt(h * (Real(2.0) * frame.top_km + h)), frame.top_km);
}

// Heights crowd at the ground. The outermost nodes stand just inside the air, where rays still have a path in it.
CONSTANT Real sky_least_height_km = Real(1.0e-3);
CONSTANT Real sky_least_depth_km = Real(0.05);

FN Real sky_height_place(Real height_km, SkyTableFrame frame) {
  Real share = clamp(height_km / (frame.top_km - frame.ground_km), Real(0.0), Real(1.0));
  return sqrt(share) * Real(frame.heights - 1);
}

FN Real sky_node_height_km(int i, SkyTableFrame frame) {
  Real thickness = frame.top_km - frame.ground_km;
  Real place = Real(i) / Real(frame.heights - 1);
  return clamp(thickness * place * place, sky_least_height_km, thickness - sky_least_depth_km);
}

// Views crowd at the horizon, on both of its sides.
FN Real sky_view_place_above(Real altitude_rad, Real dip_rad, SkyTableFrame frame) {
  Real share = (altitude_rad + dip_rad) / (Real(0.5) * pi + dip_rad);
  return sqrt(clamp(share, Real(0.0), Real(1.0))) * Real(frame.views_above - 1);
}

FN Real sky_view_place_below(Real altitude_rad, Real dip_rad, SkyTableFrame frame) {
  Real share = -(altitude_rad + dip_rad) / (Real(0.5) * pi - dip_rad);
  return sqrt(clamp(share, Real(0.0), Real(1.0))) * Real(frame.views_below - 1);
}

// Altitude of a node; rows 0 to views_below - 1 meet the ground, the first of them and the first of the others graze it.
FN Real sky_node_altitude_rad(int row, Real dip_rad, SkyTableFrame frame) {
  bool below = row < frame.views_below;
  Real place = below ? Real(row) / Real(frame.views_below - 1)
                     : Real(row - frame.views_below) / Real(frame.views_above - 1);
  Real range = below ? dip_rad - Real(0.5) * pi : Real(0.5) * pi + dip_rad;
  return range * place * place - dip_rad;
}

// Altitudes of the light are dense where dusk falls and reach to where none is left.
CONSTANT Real sky_lowest_light_rad = Real(-0.62831853); // -36 degrees
CONSTANT Real sky_dusk_rad = Real(-0.08726646);         // -5 degrees, where they are densest
CONSTANT Real sky_dusk_width_rad = Real(0.13962634);    // 8 degrees

// 0 to 1 for the lowest and the highest.
FN Real sky_light_share(Real altitude_rad) {
  Real first = arc_sinh((sky_lowest_light_rad - sky_dusk_rad) / sky_dusk_width_rad);
  Real last = arc_sinh((Real(0.5) * pi - sky_dusk_rad) / sky_dusk_width_rad);
  Real x = arc_sinh((altitude_rad - sky_dusk_rad) / sky_dusk_width_rad);
  return clamp((x - first) / (last - first), Real(0.0), Real(1.0));
}

FN Real sky_light_rad(Real share) {
  Real first = arc_sinh((sky_lowest_light_rad - sky_dusk_rad) / sky_dusk_width_rad);
  Real last = arc_sinh((Real(0.5) * pi - sky_dusk_rad) / sky_dusk_width_rad);
  Real x = mix(first, last, share);
  return sky_dusk_rad + sky_dusk_width_rad * Real(0.5) * (exp(x) - exp(-x));
}

FN Real sky_light_place(Real altitude_rad, SkyTableFrame frame) {
  return sky_light_share(altitude_rad) * Real(frame.lights - 1);
}

FN Real sky_node_light_rad(int i, SkyTableFrame frame) { return sky_light_rad(Real(i) / Real(frame.lights - 1)); }

// 1 - exp(-x) for x >= 0, exact also where x is small.
FN Real sky_share_taken(Real x) { return x < Real(1.0e-2) ? x * (Real(1.0) - x * (Real(0.5) - x / Real(6.0))) : Real(1.0) - exp(-x); }

// Share of light that the view ray's path through the air takes, in air without aerosol whose density falls with
// height by one scale: a smooth scale to measure the table's light by, nothing that is seen.
FN Real sky_path_share(Real height_km, Real altitude_rad, bool meets_ground, SkyTableFrame frame) {
  Real scale_km = Real(8.0);
  Real per_km = Real(0.025);
  Real most_scales = Real(40.0); // for a share above zero however high the air reaches
  Real h = max(height_km, Real(0.0));
  Real r = frame.ground_km + h;
  Real s = sin(altitude_rad);
  Real column = Real(0.0);
  if (meets_ground) {
    // Length of the path over the height, without cancellation, times the column of the height.
    Real root = sqrt(max(r * r * s * s - h * (Real(2.0) * frame.ground_km + h), Real(0.0)));
    column = scale_km * sky_share_taken(h / scale_km) * (Real(2.0) * frame.ground_km + h) / max(root - r * s, Real(1.0e-3));
  } else {
    // Chapman's function, as sqrt(pi x / 2) / ((sqrt(pi x / 2) - 1) s + 1).
    Real level = sqrt(Real(0.5) * pi * r / scale_km);
    Real upward = exp(-min(h / scale_km, most_scales)) * level / ((level - Real(1.0)) * abs(s) + Real(1.0));
    if (s >= Real(0.0)) {
      column = scale_km * upward;
    } else {
      Real tangent_km = max(r * cos(altitude_rad) - frame.ground_km, Real(0.0));
      Real tangent = exp(-min(tangent_km / scale_km, most_scales)) * sqrt(Real(0.5) * pi * (frame.ground_km + tangent_km) / scale_km);
      column = scale_km * max(Real(2.0) * tangent - upward, upward);
    }
  }
  return sky_share_taken(per_km * column);
}

// Weights of the nodes i - 1, i, i + 1 and i + 2 for a place t between i and i + 1: Catmull and Rom's cubic, which passes
// through the nodes with a continuous slope. A missing node before the first is the mirror image of the second, as
// befits what depends on the square of the place; one behind the last goes on in a straight line.
FN vec4 sky_cubic(Real t, bool first, bool last) {
  Real t2 = t * t;
  Real t3 = t2 * t;
  vec4 w = vec4(Real(-0.5) * t3 + t2 - Real(0.5) * t, Real(1.5) * t3 - Real(2.5) * t2 + Real(1.0),
                Real(-1.5) * t3 + Real(2.0) * t2 + Real(0.5) * t, Real(0.5) * t3 - Real(0.5) * t2);
  if (first) {
    w.z += w.x;
    w.x = Real(0.0);
  }
  if (last) {
    w.y -= w.w;
    w.z += Real(2.0) * w.w;
    w.w = Real(0.0);
  }
  return w;
}

// The four nodes around a place among `count`, and their weights.
struct SkyNodes {
  int first; // of the four, may be -1
  vec4 weights;
  int low; // of the four, those that have a weight
  int high;
};

FN SkyNodes sky_nodes(Real place, int count) {
  int i = min(int(place), count - 2);
  SkyNodes nodes;
  nodes.first = i - 1;
  nodes.weights = sky_cubic(place - Real(i), i == 0, i == count - 2);
  bool at_node = nodes.weights.y == Real(0.0) || nodes.weights.z == Real(0.0);
  nodes.low = at_node ? (nodes.weights.y == Real(0.0) ? 2 : 1) : 0;
  nodes.high = at_node ? nodes.low : 3;
  return nodes;
}

// The node number k of the four, kept in the table; where it is not there its weight is 0.
FN int sky_node(SkyNodes nodes, int k, int count) { return clamp(nodes.first + k, 0, count - 1); }

// Where an observer's view lies.
struct SkyViewPlace {
  bool meets_ground;
  int first_row; // of its side of the horizon
  int rows;
  Real place; // from the horizon
};

FN SkyViewPlace sky_view_place(Real altitude_rad, Real dip_rad, bool meets_ground, SkyTableFrame frame) {
  SkyViewPlace view;
  view.meets_ground = meets_ground;
  view.first_row = meets_ground ? 0 : frame.views_below;
  view.rows = meets_ground ? frame.views_below : frame.views_above;
  view.place = meets_ground ? sky_view_place_below(altitude_rad, dip_rad, frame)
                            : sky_view_place_above(altitude_rad, dip_rad, frame);
  return view;
}

// A table's logarithm at a row and an azimuth, between heights and altitudes of the light.
FN vec4 sky_table_between(sampler3D table, SkyNodes heights, SkyNodes lights, int row, int azimuth,
                          SkyTableFrame frame) {
  vec4 sum = vec4(Real(0.0));
  for (int h = heights.low; h <= heights.high; ++h) {
    vec4 part = vec4(Real(0.0));
    for (int l = 0; l < 4; ++l) {
      ivec3 texel = ivec3(azimuth + sky_azimuths * sky_node(lights, l, frame.lights), row,
                          sky_node(heights, h, frame.heights));
      part += lights.weights[l] * texelFetch(table, texel, 0);
    }
    sum += heights.weights[h] * part;
  }
  return sum;
}

// The share of the node number k over the azimuth in the number m of the cosine series through all nodes, which is the
// polynomial in the cosine that passes through them.
FN Real sky_series_weight(int m, int k) {
  int last = sky_azimuths - 1;
  Real weight = cos(pi * Real(m * k) / Real(last)) / Real(last);
  weight *= k == 0 || k == last ? Real(0.5) : Real(1.0);
  return weight * (m == 0 || m == last ? Real(1.0) : Real(2.0));
}

// Number m of the series at a view between a slice's rows; x of the slice counts from `first`.
FN vec4 sky_slice_between(sampler2D slice, int first, SkyViewPlace view, int m) {
  SkyNodes nodes = sky_nodes(view.place, view.rows);
  vec4 sum = vec4(Real(0.0));
  for (int k = 0; k < 4; ++k) {
    sum += nodes.weights[k] *
           texelFetch(slice, ivec2(first + m, view.first_row + sky_node(nodes, k, view.rows)), 0);
  }
  return sum;
}

// The logarithm of the mean source in a direction for any observer, straight from the table.
FN vec4 sky_table_log2(sampler3D table, Real height_km, SkyViewPlace view, Real light_altitude_rad, Real cos_azimuth,
                       SkyTableFrame frame) {
  SkyNodes heights = sky_nodes(sky_height_place(height_km, frame), frame.heights);
  SkyNodes lights = sky_nodes(sky_light_place(light_altitude_rad, frame), frame.lights);
  SkyNodes rows = sky_nodes(view.place, view.rows);
  // The series through the nodes, in its barycentric form (Berrut and Trefethen 2004, SIAM Review 46, 501).
  int last = sky_azimuths - 1;
  vec4 sum = vec4(Real(0.0));
  Real all = Real(0.0);
  for (int k = 0; k < sky_azimuths; ++k) {
    Real apart = cos_azimuth - cos(pi * Real(k) / Real(last));
    Real share = (k == 0 || k == last ? Real(0.5) : Real(1.0)) / (abs(apart) < Real(1.0e-6) ? Real(1.0e-6) : apart);
    share = k % 2 == 0 ? share : -share;
    all += share;
    for (int r = 0; r < 4; ++r) {
      if (rows.weights[r] != Real(0.0)) {
        int row = view.first_row + sky_node(rows, r, view.rows);
        sum += share * rows.weights[r] * sky_table_between(table, heights, lights, row, k, frame);
      }
    }
  }
  return sum / all;
}

// Share of a light that is left after the air toward space, as a logarithm to base 2 of X, Y, Z and S, for a view that
// is free of the ground. x: altitude over the horizon, crowded there; y: height. As many rows follow for views of the
// ground (sky_ground_view_log2).
struct SkyTransmittanceFrame {
  int altitudes;
  int heights;
};

FN Real sky_transmittance_node_rad(int i, Real dip_rad, SkyTransmittanceFrame nodes) {
  Real place = Real(i) / Real(nodes.altitudes - 1);
  return (Real(0.5) * pi + dip_rad) * place * place - dip_rad;
}

FN vec4 sky_transmittance_log2(sampler2D table, Real height_km, Real altitude_rad, SkyTransmittanceFrame nodes,
                               SkyTableFrame frame) {
  Real dip = sky_dip(height_km, frame);
  Real over = clamp((altitude_rad + dip) / (Real(0.5) * pi + dip), Real(0.0), Real(1.0));
  Real share = clamp(height_km / (frame.top_km - frame.ground_km), Real(0.0), Real(1.0));
  SkyNodes columns = sky_nodes(sqrt(over) * Real(nodes.altitudes - 1), nodes.altitudes);
  SkyNodes rows = sky_nodes(sqrt(share) * Real(nodes.heights - 1), nodes.heights);
  vec4 sum = vec4(Real(0.0));
  for (int r = rows.low; r <= rows.high; ++r) {
    for (int c = 0; c < 4; ++c) {
      sum += rows.weights[r] * columns.weights[c] *
             texelFetch(table, ivec2(sky_node(columns, c, nodes.altitudes), sky_node(rows, r, nodes.heights)), 0);
    }
  }
  return min(sum, vec4(Real(0.0)));
}

// Share of a light's disc above the geometric horizon.
FN Real sky_disc_visible(Real altitude_rad, Real dip_rad, Real radius_rad) {
  Real x = (altitude_rad + dip_rad) / max(radius_rad, Real(1.0e-6));
  if (abs(x) >= Real(1.0)) {
    return x > Real(0.0) ? Real(1.0) : Real(0.0);
  }
  return Real(0.5) + (x * sqrt(Real(1.0) - x * x) + asin(x)) / pi;
}

// Illuminance of level ground at sea level by scattered light, as a logarithm to base 2, over the light's altitude.
FN vec4 sky_ground_log2(sampler1D table, Real light_altitude_rad, SkyTableFrame frame) {
  SkyNodes lights = sky_nodes(sky_light_place(light_altitude_rad, frame), frame.lights);
  vec4 sum = vec4(Real(0.0));
  for (int l = 0; l < 4; ++l) {
    sum += lights.weights[l] * texelFetch(table, sky_node(lights, l, frame.lights), 0);
  }
  return sum;
}

// The phase function that light scattered once by aerosol is held without, per steradian, in x: its logarithm to base 2
// at equal steps of the square root of the angle.
FN Real sky_aerosol_phase(sampler1D table, Real cos_angle, int count) {
  Real bounded = clamp(cos_angle, Real(-1.0), Real(1.0));
  Real angle = atan(sqrt((Real(1.0) - bounded) * (Real(1.0) + bounded)), bounded);
  SkyNodes nodes = sky_nodes(sqrt(angle / pi) * Real(count - 1), count);
  Real sum = Real(0.0);
  for (int k = 0; k < 4; ++k) {
    sum += nodes.weights[k] * texelFetch(table, sky_node(nodes, k, count), 0).x;
  }
  return exp2(sum);
}

// Way from an observer to the ground, km, for a view that meets it.
FN Real sky_ground_distance_km(Real height_km, Real altitude_rad, SkyTableFrame frame) {
  Real above = height_km * (Real(2.0) * frame.ground_km + height_km);
  Real rise = (frame.ground_km + height_km) * sin(altitude_rad);
  return above / max(sqrt(max(rise * rise - above, Real(0.0))) - rise, Real(1.0e-3));
}

FN Real sky_ground_view_node_rad(int i, Real dip_rad, SkyTransmittanceFrame nodes) {
  Real place = Real(i) / Real(nodes.altitudes - 1);
  return (dip_rad - Real(0.5) * pi) * place * place - dip_rad;
}

// Share of a light that passes from a point of the ground to an observer, as a logarithm to base 2; the altitude is
// that of the point as the observer sees it, below the horizon. The rows behind those of the transmittance toward space
// hold it over the way, in km: the quotient of two shares would not do, since what has lost its blue loses less.
FN vec4 sky_ground_view_log2(sampler2D transmittance, Real height_km, Real altitude_rad, SkyTransmittanceFrame nodes,
                             SkyTableFrame frame) {
  Real h = clamp(height_km, Real(0.0), frame.top_km - frame.ground_km);
  Real dip = sky_dip(h, frame);
  Real under = clamp(-(altitude_rad + dip) / (Real(0.5) * pi - dip), Real(0.0), Real(1.0));
  SkyNodes columns = sky_nodes(sqrt(under) * Real(nodes.altitudes - 1), nodes.altitudes);
  SkyNodes rows = sky_nodes(sqrt(h / (frame.top_km - frame.ground_km)) * Real(nodes.heights - 1), nodes.heights);
  vec4 sum = vec4(Real(0.0));
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      ivec2 texel = ivec2(sky_node(columns, c, nodes.altitudes), nodes.heights + sky_node(rows, r, nodes.heights));
      sum += rows.weights[r] * columns.weights[c] * texelFetch(transmittance, texel, 0);
    }
  }
  return min(sum * sky_ground_distance_km(h, altitude_rad, frame), vec4(Real(0.0)));
}

// Illuminance of level ground at sea level above 1 lux of sunlight: direct and diffuse.
// light: X, Y, Z and S of that sunlight.
FN vec4 sky_ground_illuminance(sampler1D ground, sampler2D transmittance, vec4 light, Real light_altitude_rad,
                               Real light_radius_rad, SkyTransmittanceFrame nodes, SkyTableFrame frame) {
  Real visible = sky_disc_visible(light_altitude_rad, Real(0.0), light_radius_rad);
  // What is left of a disc that the horizon cuts stands above the horizon.
  Real middle = max(light_altitude_rad, Real(0.5) * (light_altitude_rad + light_radius_rad));
  vec4 direct = vec4(Real(0.0));
  if (visible > Real(0.0)) {
    direct = light * (visible * max(sin(middle), Real(0.0))) *
             exp2(sky_transmittance_log2(transmittance, Real(0.0), middle, nodes, frame));
  }
  return direct + exp2(sky_ground_log2(ground, light_altitude_rad, frame));
}
