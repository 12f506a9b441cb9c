#pragma once

namespace vesper {

/// Model tiers that all programs name `cheap`, `default` and `reference`.
enum class Tier { cheap, standard, reference };

} // namespace vesper
