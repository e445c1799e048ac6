#include "sph_backend/mirror.h"

#include "sph_backend/pair_kernels.h"

namespace apc::sph {

std::vector<Image> make_images(const std::vector<float>& records, const std::vector<std::int32_t>& ids,
                               std::size_t count, const std::vector<MirrorPlane>& planes, const double origin[3],
                               float range) {
  std::vector<Image> images;
  const auto coordinate = [&](std::uint32_t parent, int axis) { return records[parent * record::size + axis]; };
  for (const auto& plane : planes) {
    const float at = static_cast<float>(plane.position - origin[plane.axis]), side = static_cast<float>(plane.side);
    const auto add = [&](Image image) {  // by value: the vector grows
      const float here = image.sign[plane.axis] * coordinate(image.parent, plane.axis) + image.shift[plane.axis];
      if (side * (here - at) > range) return;
      image.sign[plane.axis] = -image.sign[plane.axis];
      image.shift[plane.axis] = 2.0f * at - image.shift[plane.axis];
      images.push_back(image);
    };
    const std::size_t earlier = images.size();
    for (std::size_t i = 0; i < count; ++i)
      if (ids[i] >= 0) add(Image{static_cast<std::uint32_t>(i), {1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.0f}});
    for (std::size_t k = 0; k < earlier; ++k) add(images[k]);
  }
  return images;
}

void refresh_motion(std::vector<float>& records, std::size_t count, const std::vector<Image>& images) {
  using namespace record;
  float* to = records.data() + count * record::size;
  for (const Image& image : images) {
    const float* from = records.data() + static_cast<std::size_t>(image.parent) * record::size;
    for (int a = 0; a < 3; ++a) {
      to[x + a] = image.sign[a] * from[x + a] + image.shift[a];
      to[vx + a] = image.sign[a] * from[vx + a];
    }
    to[inverse_h] = from[inverse_h], to[visc_a] = from[visc_a], to[visc_b] = from[visc_b], to[volume] = from[volume];
    to += record::size;
  }
}

void refresh_stress(std::vector<float>& records, std::size_t count, const std::vector<Image>& images) {
  using namespace record;
  float* to = records.data() + count * record::size;
  for (const Image& image : images) {
    const float* from = records.data() + static_cast<std::size_t>(image.parent) * record::size;
    to[sxx] = from[sxx], to[syy] = from[syy], to[szz] = from[szz];
    to[sxy] = image.sign[0] * image.sign[1] * from[sxy];
    to[sxz] = image.sign[0] * image.sign[2] * from[sxz];
    to[syz] = image.sign[1] * image.sign[2] * from[syz];
    to += record::size;
  }
}

}  // namespace apc::sph
