#include "apc/base/markup.h"

#include <gtest/gtest.h>

namespace apc {
namespace {

TEST(Markup, EscapesWhatWouldBeReadAsMarkup) {
  EXPECT_EQ(escaped("a < b & c > \"d\" 'e'"), "a &lt; b &amp; c &gt; &quot;d&quot; &#39;e&#39;");
  EXPECT_EQ(escaped("&amp;"), "&amp;amp;");
  EXPECT_EQ(escaped("Zürich 18 in"), "Zürich 18 in");
}

}  // namespace
}  // namespace apc
