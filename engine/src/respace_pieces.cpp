#include "respace_pieces.hpp"

#include "shoreline/boundary/respacing.hpp"

namespace shoreline {

void respace_pieces(Scene& scene, int step, StepWarnings& said, std::vector<std::string>& warnings) {
  if (scene.respacing == 0.0) return;
  for (std::size_t k = 0; k < scene.boundary.size(); ++k) {
    BoundaryPiece& b = scene.boundary[k];
    std::optional<Respaced> respaced = respace(b.piece, scene.respacing);
    if (!respaced) continue;
    *b.original = respaced_original(*b.original, *respaced);
    for (const auto& effect : scene.contributions) effect->respace(static_cast<int>(k), respaced->places);
    b.piece = std::move(respaced->piece);
    said.add("respaced " + b.piece.name, step,
             fmt::format("chords of piece '{}' differed by more than a factor of {:.3g}; its tracking points were "
                         "re-spaced along the curve",
                         b.piece.name, scene.respacing),
             warnings);
  }
}

}  // namespace shoreline
