// Eclipses of the Moon: the shares of X, Y, Z and S that the Earth's shadow leaves of uneclipsed moonlight, for each
// point of the Moon.

CONSTANT int lunar_eclipse_none = 0;
CONSTANT int lunar_eclipse_published = 1; // a colour map over the shadow's circles
CONSTANT int lunar_eclipse_table = 2;     // a table of the light refracted and scattered into the shadow

// Where the shares by wavelength are known (vesper/atmosphere/earth_shadow_light.hpp): in columns from the axis to where
// the air no longer touches the sunlight, in equal steps of arc_sinh(distance from the edge / width) on either side of
// the umbra's edge, near which the light changes most; in rows at equal steps along the axis.
struct LunarEclipseMap {
  int inner;  // intervals from the axis to the edge
  int outer;  // and on to full light
  int rows;   // at least 2
  Real first_km; // along the axis, of the first row
  Real rows_per_km;
  Real edge_km;  // radii of the Earth with as much air as casts the umbra's edge, and all of it
  Real clear_km;
  Real width_km;
};

// The table of one frame, so fine that equal steps will do: columns by the distance from the umbra's edge, rows along
// the axis. Texels are the shares, 1 in the last column.
struct LunarEclipseFrame {
  int kind;
  int columns; // at least 2
  int rows;    // likewise
  Real first_km; // along the axis, of the first row
  Real rows_per_km;
  Real edge_km;  // radius of the umbra's edge at the Earth's centre, if it went on straight; and its growth
  Real edge_per_km;
  Real inside_km; // how far inside of the edge the first column is
  Real columns_per_km;
};

// The same shadow of another Earth.
FN EarthShadow shadow_with_edge(EarthShadow shadow, Real edge_radius_km) {
  EarthShadow other = shadow;
  other.edge_radius_km = edge_radius_km;
  return other;
}

// Radii of the umbra's edge and of full light at a distance along the axis, km. Beyond the umbra's tip its edge stays a
// circle of 1 km.
FN vec2 lunar_eclipse_radii_km(Real along_km, EarthShadow shadow, LunarEclipseMap map) {
  Real edge = max(earth_shadow_radii_km(along_km, shadow_with_edge(shadow, map.edge_km)).x, Real(1.0));
  Real clear = earth_shadow_radii_km(along_km, shadow_with_edge(shadow, map.clear_km)).y;
  return vec2(edge, clear);
}

// The column (x) and row (y), fractions included, of a place (earth_shadow_place) behind the Earth.
FN vec2 lunar_eclipse_texel(vec2 place_km, EarthShadow shadow, LunarEclipseMap map) {
  vec2 radii = lunar_eclipse_radii_km(place_km.y, shadow, map);
  bool inside = place_km.x < radii.x;
  Real full = inside ? radii.x : radii.y - radii.x;
  Real off = min(abs(place_km.x - radii.x), full);
  Real share = arc_sinh(off / map.width_km) / arc_sinh(full / map.width_km);
  Real column = Real(map.inner) + share * (inside ? -Real(map.inner) : Real(map.outer));
  Real row = clamp((place_km.y - map.first_km) * map.rows_per_km, Real(0.0), Real(map.rows - 1));
  return vec2(column, row);
}

// Distance from the axis, km, to which a column belongs.
FN Real lunar_eclipse_axis_distance_km(Real column, Real along_km, EarthShadow shadow, LunarEclipseMap map) {
  vec2 radii = lunar_eclipse_radii_km(along_km, shadow, map);
  Real off = column - Real(map.inner);
  Real full = off < Real(0.0) ? radii.x : radii.y - radii.x;
  Real x = off / (off < Real(0.0) ? Real(map.inner) : Real(map.outer)) * arc_sinh(full / map.width_km);
  return max(radii.x + map.width_km * Real(0.5) * (exp(x) - exp(-x)), Real(0.0));
}

// The cheap tier, Mueller et al. 2012, sec. 3.2: a colour by the phase, 0 on the axis, 1/2 at the edge of the umbra, 1
// at that of the penumbra, both of them geometric circles. (The paper's second curve, up to 30 times more light by how
// deep the Moon stands, is an exposure and no light: it belongs to the display.)
FN Real lunar_eclipse_phase(vec2 place_km, EarthShadow shadow) {
  vec2 radii = earth_shadow_radii_km(place_km.y, shadow);
  if (place_km.x < radii.x) {
    return Real(0.5) * place_km.x / radii.x;
  }
  Real inner = max(radii.x, Real(0.0));
  return Real(0.5) + Real(0.5) * min((place_km.x - inner) / (radii.y - inner), Real(1.0));
}

// The paper prints its curves (fig. 5) without figures. These have their four parts: a soft penumbra, a dark umbra that
// darkens and reddens towards the axis, a bluish rim. Their constants follow the table's light for L = 2.5, within a
// factor of 2 in the umbra.
FN vec4 lunar_eclipse_colors(Real phase) {
  Real lit = max(Real(2.0) * phase - Real(1.0), Real(0.0));
  Real deep = max(Real(1.0) - Real(2.0) * phase, Real(0.0));
  Real sun = lit * sqrt(lit) * (Real(2.1) - Real(1.1) * lit);
  vec4 umbra = exp(vec4(Real(-8.0), Real(-8.0), Real(-7.9), Real(-7.9)) -
                   deep * vec4(Real(4.4), Real(4.9), Real(6.8), Real(6.0)));
  return umbra + (vec4(Real(1.0)) - umbra) * sun;
}

// Shares of X, Y, Z and S at a point (km, from the Earth's centre): 1 in front of the Earth and outside the shadow.
FN vec4 lunar_eclipse_shares(vec3 point_km, EarthShadow shadow, LunarEclipseFrame frame, sampler2D table) {
  vec2 place = earth_shadow_place(point_km, shadow);
  if (frame.kind == lunar_eclipse_none || place.y <= Real(0.0)) {
    return vec4(Real(1.0));
  }
  if (frame.kind == lunar_eclipse_published) {
    return lunar_eclipse_colors(lunar_eclipse_phase(place, shadow));
  }
  Real off = place.x - (frame.edge_km + frame.edge_per_km * place.y);
  Real column = clamp((off + frame.inside_km) * frame.columns_per_km, Real(0.0), Real(frame.columns - 1));
  Real row = clamp((place.y - frame.first_km) * frame.rows_per_km, Real(0.0), Real(frame.rows - 1));
  int i = min(int(column), frame.columns - 2);
  int j = min(int(row), frame.rows - 2);
  Real across = column - Real(i);
  vec4 near = mix(texelFetch(table, ivec2(i, j), 0), texelFetch(table, ivec2(i + 1, j), 0), across);
  vec4 far = mix(texelFetch(table, ivec2(i, j + 1), 0), texelFetch(table, ivec2(i + 1, j + 1), 0), across);
  return mix(near, far, row - Real(j));
}
