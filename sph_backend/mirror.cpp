#include "sph_backend/mirror.h"

#include <algorithm>

#include "sph_backend/pair_kernels.h"

namespace apc::sph {
namespace {

constexpr int piece = 1024;  // images or particles of one piece of work

}  // namespace

std::vector<Image> make_images(const std::vector<float>& records, const std::vector<std::int32_t>& ids,
                               std::size_t count, const std::vector<MirrorPlane>& planes, const double origin[3],
                               float range, Team& team) {
  std::vector<std::vector<Image>> parts((count + piece - 1) / piece);
  team.run(static_cast<int>(parts.size()), 1, [&](int first, int last) {
    for (int k = first; k < last; ++k) {
      std::vector<Image>& images = parts[k];
      for (std::size_t i = static_cast<std::size_t>(k) * piece; i < std::min<std::size_t>((k + 1) * piece, count);
           ++i) {
        if (ids[i] < 0) continue;
        const std::size_t own = images.size();  // this parent's images begin here
        for (const auto& plane : planes) {
          const float at = static_cast<float>(plane.position - origin[plane.axis]),
                      side = static_cast<float>(plane.side);
          const float parent = records[i * record::size + plane.axis];
          const auto add = [&](Image image) {  // by value: the vector grows
            if (side * (image.sign[plane.axis] * parent + image.shift[plane.axis] - at) > range) return;
            image.sign[plane.axis] = -image.sign[plane.axis];
            image.shift[plane.axis] = 2.0f * at - image.shift[plane.axis];
            images.push_back(image);
          };
          const std::size_t earlier = images.size();
          add({static_cast<std::uint32_t>(i), {1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.0f}});
          for (std::size_t n = own; n < earlier; ++n) add(images[n]);
        }
      }
    }
  });
  std::size_t total = 0;
  for (const auto& part : parts) total += part.size();
  std::vector<Image> images;
  images.reserve(total);
  for (const auto& part : parts) images.insert(images.end(), part.begin(), part.end());
  return images;
}

void refresh_motion(std::vector<float>& records, std::size_t count, const std::vector<Image>& images, Team& team) {
  using namespace record;
  team.run(static_cast<int>(images.size()), piece, [&](int first, int last) {
    for (int k = first; k < last; ++k) {
      const Image& image = images[k];
      const float* from = records.data() + static_cast<std::size_t>(image.parent) * record::size;
      float* to = records.data() + (count + k) * record::size;
      for (int a = 0; a < 3; ++a) {
        to[x + a] = image.sign[a] * from[x + a] + image.shift[a];
        to[vx + a] = image.sign[a] * from[vx + a];
      }
      to[quarter_inverse_h] = from[quarter_inverse_h], to[visc_a] = from[visc_a], to[visc_b] = from[visc_b];
      to[volume] = from[volume];
    }
  });
}

void refresh_stress(std::vector<float>& records, std::size_t count, const std::vector<Image>& images, Team& team) {
  using namespace record;
  team.run(static_cast<int>(images.size()), piece, [&](int first, int last) {
    for (int k = first; k < last; ++k) {
      const Image& image = images[k];
      const float* from = records.data() + static_cast<std::size_t>(image.parent) * record::size;
      float* to = records.data() + (count + k) * record::size;
      to[sxx] = from[sxx], to[syy] = from[syy], to[szz] = from[szz];
      to[sxy] = image.sign[0] * image.sign[1] * from[sxy];
      to[sxz] = image.sign[0] * image.sign[2] * from[sxz];
      to[syz] = image.sign[1] * image.sign[2] * from[syz];
      to[volume] = from[volume];
    }
  });
}

}  // namespace apc::sph
