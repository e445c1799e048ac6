#include "apc/cli/sph_deck.h"

#include <vector>

#include "aircraft/aircraft.h"
#include "apc/base/file.h"
#include "apc/base/json.h"
#include "apc/base/require.h"
#include "apc/cli/inputs.h"
#include "sph_backend/deck_json.h"

namespace apc::cli {
namespace {

namespace fs = std::filesystem;

sph::TireShape find_shape(const std::string& name, const fs::path& deck, const aircraft::TireLibrary& library) {
  const auto found = library.find(name);
  if (found == library.end()) {
    std::vector<std::string> known;
    for (const auto& [each, tire] : library) known.push_back(each);
    const auto near = nearest(name, known.data(), known.size());
    throw InputError(concat(deck.string(), " /tire: \"", name, "\" is not in the tire library.",
                            near.empty() ? std::string() : concat(" Did you mean \"", near, "\"?"),
                            " \"apc list tires\" names the shipped ones"));
  }
  const auto& tire = found->second;
  return {tire.name,       tire.diameter,         tire.width,          tire.rim_diameter,        tire.inflation,
          tire.rated_load, tire.rated_deflection, tire.bottoming_load, tire.bottoming_deflection};
}

/// A material file beside the deck, or a shipped name.
fs::path find_material(const std::string& name, const fs::path& deck) {
  std::error_code error;
  if (const auto beside = deck.parent_path() / name; fs::is_regular_file(beside, error)) return beside;
  try {
    return resolve(name, "designs/materials", "material");
  } catch (const InputError& reason) {
    throw InputError(concat(deck.string(), " /material: ", reason.what()));
  }
}

}  // namespace

SphDeck read_deck(const fs::path& given) {
  const auto path = resolve(given.string(), "designs/sph", "deck");
  SphDeck out;
  const auto json = read_json(path);
  out.name = json.has("name") ? json.text("name") : path.stem().string();
  out.source = json.has("source") ? json.text("source") : "";
  out.files.push_back(note("deck", path, out.source));
  const sph::DeckNames names{
      [&](const std::string& name) { return find_shape(name, path, read_tires({}, path, out.files)); },
      [&](const std::string& name) {
        const auto file = find_material(name, path);
        out.files.push_back(note("material", file, ""));
        return file;
      }};
  out.rig = sph::load_deck(path, names);
  out.material = out.rig.foam.name;
  return out;
}

}  // namespace apc::cli
