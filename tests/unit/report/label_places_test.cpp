#include "apc/report/label_places.h"

#include <gtest/gtest.h>

namespace apc::report {
namespace {

const Box frame{60, 10, 430, 200};

/// The text's box at the size the class reckons with.
Box box_of(const LabelPlace& place, std::size_t letters) {
  const double wide = 7.2 * static_cast<double>(letters);
  const double left = place.anchor == "start" ? place.x : place.anchor == "end" ? place.x - wide : place.x - wide / 2;
  return {left, place.y - 11, left + wide, place.y + 3};
}

bool apart(const Box& a, const Box& b) {
  return a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
}

TEST(LabelPlaces, AboveItsLineAtTheRightWhenNothingIsThere) {
  LabelPlaces places(frame);
  places.avoid_level(100);
  const auto place = places.at_level(100, 16);
  EXPECT_EQ(place.anchor, "end");
  EXPECT_EQ(place.y, 95);
}

TEST(LabelPlaces, KeepsOffACurveOnItsRight) {
  LabelPlaces places(frame);
  places.avoid_level(100);
  places.avoid_curve({250, 430}, {95, 95});
  places.avoid_curve({250, 430}, {112, 112});
  const auto place = places.at_level(100, 16);
  EXPECT_LT(box_of(place, 16).right, 250);
}

TEST(LabelPlaces, NamesOfLinesThatLieCloseShareNoPlaceAndCrossNoLine) {
  LabelPlaces places(frame);
  const double levels[] = {60, 66, 72};
  for (const double y : levels) places.avoid_level(y);
  std::vector<Box> boxes;
  for (const double y : levels) boxes.push_back(box_of(places.at_level(y, 20), 20));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) EXPECT_TRUE(apart(boxes[i], boxes[j])) << i << " " << j;
    EXPECT_GE(boxes[i].top, frame.top);
    EXPECT_LE(boxes[i].right, frame.right);
  }
}

TEST(LabelPlaces, OfAnUprightLineStaysInsideAtTheRightEdge) {
  LabelPlaces places(frame);
  places.avoid_curve({425, 425}, {10, 200});
  const auto place = places.at_vertical(425, 14);
  EXPECT_EQ(place.anchor, "end");
}

TEST(LettersOf, CountsLettersNotBytes) { EXPECT_EQ(letters_of("1 m/s² – é"), 10u); }

}  // namespace
}  // namespace apc::report
