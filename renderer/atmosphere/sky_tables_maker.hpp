// Tables for a medium that changes while they are in use: made beside the work that goes on with the old ones.
#pragma once

#include "vesper/atmosphere/sky_tables.hpp"

#include <memory>

namespace vesper {

/// Makes tables in a thread of its own. Of several media that are asked for, only the last counts: a run that it makes
/// obsolete is given up at its next report of progress, and media asked for in between are never begun. All members may
/// be called by any thread, and none of them waits for tables.
class SkyTablesMaker {
public:
  /// How tables are made; ends with what `progress` throws.
  using Make = std::function<SkyTables(const Medium& medium, const Progress& progress)>;

  /// \param make by default make_sky_tables in its default size, with half of the cores: the others draw
  explicit SkyTablesMaker(Make make = {});
  /// Gives up what is being made.
  ~SkyTablesMaker();
  SkyTablesMaker(const SkyTablesMaker&) = delete;
  SkyTablesMaker& operator=(const SkyTablesMaker&) = delete;

  /// Begins to make tables of the medium, in place of all that was asked for before. Tables that are finished but not
  /// yet taken are dropped: they are of an older medium.
  void request(std::shared_ptr<const Medium> medium);

  /// The finished tables of the last request, once; null before and after. Throws what making them threw, once: the
  /// maker then waits for the next request.
  [[nodiscard]] std::shared_ptr<const SkyTables> take();

  /// What share of the last request is done, 0 to 1; 1 when there is nothing to do.
  [[nodiscard]] double progress() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace vesper
