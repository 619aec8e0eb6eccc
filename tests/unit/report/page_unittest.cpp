#include "flownav/report/page.h"

#include <gtest/gtest.h>

#include "flownav/report/html.h"
#include "flownav/report/palette.h"

namespace flownav::report {
namespace {

int count_of(const std::string& text, const std::string& part) {
    int count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(Html, TextsCannotBecomeMarkup) {
    EXPECT_EQ(html::escaped("<a href='x'>\"&"), "&lt;a href=&#39;x&#39;&gt;&quot;&amp;");
}

TEST(Palette, PicturesAndPagesHaveTheSameColours) {
    EXPECT_EQ(palette::blue.css(), "#0072b2");
    EXPECT_EQ(palette::blue.bgr(), cv::Vec3b(0xb2, 0x72, 0x00));
    EXPECT_EQ(cv::Scalar(palette::blue), cv::Scalar(0xb2, 0x72, 0x00));
    EXPECT_NE(css_variables().find(" --blue: #0072b2;"), std::string::npos);
    EXPECT_NE(css_variables().find(" --sky-blue: #56b4e9;"), std::string::npos);
}

TEST(Page, TitleFooterAndDataAreTexts) {
    const std::string html = page_html(
        {"<title-of-page>", "<p>body</p>", "<foot>", R"({"name": "</script>"})", ".own {}", "own();"});
    EXPECT_EQ(count_of(html, "&lt;title-of-page&gt;"), 2) << "title and heading";
    EXPECT_EQ(count_of(html, "<title-of-page>") + count_of(html, "<foot>"), 0);
    EXPECT_EQ(count_of(html, "<script"), count_of(html, "</script>"));
    EXPECT_EQ(count_of(html, "<p>body</p>") + count_of(html, ".own {}") + count_of(html, "own();"), 3);
}

TEST(Page, WithoutDataThereIsNoScript) {
    EXPECT_EQ(count_of(page_html({"title", "", "", "", "", "own();"}), "<script"), 0);
}

}  // namespace
}  // namespace flownav::report
