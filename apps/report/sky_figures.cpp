#include "report/sky_figures.hpp"

#include <algorithm>
#include <array>

namespace vesper {
namespace {

template <class... Numbers> constexpr std::array<std::uint16_t, sizeof...(Numbers)> stars(Numbers... hr) {
  return {static_cast<std::uint16_t>(hr)...};
}

constexpr auto orion = stars(2061, 1790, 1852, 1903, 1948, 2004, 1713);
constexpr auto plough = stars(4301, 4295, 4554, 4660, 4905, 5054, 5191);
constexpr auto cassiopeia = stars(21, 168, 264, 403, 542);
constexpr auto little_bear = stars(424, 5563, 5735);
constexpr auto cygnus = stars(7924, 7796, 7949, 7528, 7417);
constexpr auto lyra = stars(7001, 7106, 7178);
constexpr auto aquila = stars(7557, 7525, 7602);
constexpr auto leo = stars(3982, 4057, 4534, 4357, 4359);
constexpr auto bootes = stars(5340, 5506, 5235, 5435, 5602);
constexpr auto gemini = stars(2891, 2990, 2421, 2286, 2473);
constexpr auto taurus = stars(1457, 1791, 1910, 1165);
constexpr auto auriga = stars(1708, 2088, 2095, 1577);
constexpr auto canis_major = stars(2491, 2618, 2693, 2294, 2827);
constexpr auto perseus = stars(1017, 936, 915, 1122, 1220);
constexpr auto pegasus = stars(8781, 8775, 39, 15);
constexpr auto scorpius = stars(6134, 5953, 5984, 6241, 6527, 6553);
constexpr auto sagittarius = stars(6879, 6859, 6913, 7039, 7121, 7194, 6746);
constexpr auto crux = stars(4730, 4853, 4763, 4656);
constexpr auto pointers = stars(5459, 5267);
constexpr auto false_cross = stars(3307, 3699, 3485, 3734);

constexpr std::array figures{
    SkyFigure{"Orion", orion},
    SkyFigure{"the Plough", plough},
    SkyFigure{"Cassiopeia", cassiopeia},
    SkyFigure{"the Little Bear", little_bear},
    SkyFigure{"Cygnus", cygnus},
    SkyFigure{"Lyra", lyra},
    SkyFigure{"Aquila", aquila},
    SkyFigure{"Leo", leo},
    SkyFigure{"Bootes", bootes},
    SkyFigure{"Gemini", gemini},
    SkyFigure{"Taurus", taurus},
    SkyFigure{"Auriga", auriga},
    SkyFigure{"Canis Major", canis_major},
    SkyFigure{"Perseus", perseus},
    SkyFigure{"the Square of Pegasus", pegasus},
    SkyFigure{"Scorpius", scorpius},
    SkyFigure{"the Teapot of Sagittarius", sagittarius},
    SkyFigure{"the Southern Cross", crux},
    SkyFigure{"Alpha and Beta Centauri", pointers},
    SkyFigure{"the False Cross", false_cross},
};

constexpr std::array names{
    NamedStar{15, "Alpheratz"},        NamedStar{188, "Diphda"},      NamedStar{337, "Mirach"},
    NamedStar{424, "Polaris"},         NamedStar{472, "Achernar"},    NamedStar{617, "Hamal"},
    NamedStar{936, "Algol"},           NamedStar{1017, "Mirfak"},     NamedStar{1457, "Aldebaran"},
    NamedStar{1708, "Capella"},        NamedStar{1713, "Rigel"},      NamedStar{1790, "Bellatrix"},
    NamedStar{1791, "Elnath"},         NamedStar{1903, "Alnilam"},    NamedStar{1948, "Alnitak"},
    NamedStar{2004, "Saiph"},          NamedStar{2061, "Betelgeuse"}, NamedStar{2088, "Menkalinan"},
    NamedStar{2294, "Mirzam"},         NamedStar{2326, "Canopus"},    NamedStar{2421, "Alhena"},
    NamedStar{2491, "Sirius"},         NamedStar{2618, "Adhara"},     NamedStar{2693, "Wezen"},
    NamedStar{2891, "Castor"},         NamedStar{2943, "Procyon"},    NamedStar{2990, "Pollux"},
    NamedStar{3307, "Avior"},          NamedStar{3485, "Alsephina"},  NamedStar{3685, "Miaplacidus"},
    NamedStar{3748, "Alphard"},        NamedStar{3982, "Regulus"},    NamedStar{4057, "Algieba"},
    NamedStar{4301, "Dubhe"},          NamedStar{4534, "Denebola"},   NamedStar{4730, "Acrux"},
    NamedStar{4763, "Gacrux"},         NamedStar{4853, "Mimosa"},     NamedStar{4905, "Alioth"},
    NamedStar{5056, "Spica"},          NamedStar{5191, "Alkaid"},     NamedStar{5267, "Hadar"},
    NamedStar{5288, "Menkent"},        NamedStar{5340, "Arcturus"},   NamedStar{5459, "Rigil Kentaurus"},
    NamedStar{5563, "Kochab"},         NamedStar{6134, "Antares"},    NamedStar{6217, "Atria"},
    NamedStar{6527, "Shaula"},         NamedStar{6553, "Sargas"},     NamedStar{6556, "Rasalhague"},
    NamedStar{6879, "Kaus Australis"}, NamedStar{7001, "Vega"},       NamedStar{7121, "Nunki"},
    NamedStar{7557, "Altair"},         NamedStar{7790, "Peacock"},    NamedStar{7924, "Deneb"},
    NamedStar{8425, "Alnair"},         NamedStar{8728, "Fomalhaut"},
};

} // namespace

std::span<const SkyFigure> sky_figures() { return figures; }

std::span<const NamedStar> named_stars() { return names; }

std::string_view proper_name(std::uint32_t hr) {
  const auto* const found =
      std::find_if(names.begin(), names.end(), [&](const NamedStar& star) { return star.hr == hr; });
  return found == names.end() ? std::string_view() : found->name;
}

} // namespace vesper
