#include "apc/report/page_parts.h"

#include <fmt/format.h>

#include <cmath>

#include "apc/report/page_style.h"
#include "apc/report/svg.h"

namespace apc::report {

std::string page_head(const std::string& title) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width,initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><title>" +
         escaped(title) + "</title><style>" + page_style + "</style></head>\n<body>\n" + page_switches;
}

std::string page_end(const std::string& data) {
  return "<script type=\"application/json\" id=\"series\">" + data + "</script>\n<script>" + page_script +
         "</script>\n</body></html>\n";
}

std::string switches_bar() {
  return "<div class=\"bar-of-switches\"><span class=\"group\">Units <label for=\"units-field\">field</label>"
         "<label for=\"units-si\">SI</label></span><span class=\"group\">Plots over <label "
         "for=\"over-distance\">distance"
         "</label><label for=\"over-time\">time</label></span></div>\n";
}

std::string card(const std::string& mood, const std::string& label, const std::string& value, const std::string& more) {
  return fmt::format(
      "<div class=\"card {}\"><span class=\"label\">{}</span><b>{}</b><span class=\"more\">{}</span></div>\n", mood,
      label, value, more);
}

std::string row(const std::string& name, const std::string& value) {
  return "<tr><th>" + name + "</th><td>" + value + "</td></tr>\n";
}

std::string file_row(const InputFile& file) {
  return row(escaped(file.role), "<code>" + escaped(file.path) + "<br>sha256 " + escaped(file.sha256) + "</code>");
}

std::string series(const std::vector<Plot>& plots, const Abscissa& axes) {
  const auto list = [](const std::vector<double>& values) {
    std::string out = "[";
    for (std::size_t i = 0; i < values.size(); ++i)
      out += (i ? "," : "") + (std::isfinite(values[i]) ? fmt::format("{:.5g}", values[i]) : std::string("null"));
    return out + "]";
  };
  std::string out = "{\"distance\":" + list(axes.distance) + ",\"time\":" + list(axes.time) + ",\"plots\":[";
  for (std::size_t i = 0; i < plots.size(); ++i) {
    out += i ? ",[" : "[";
    for (std::size_t j = 0; j < plots[i].curves.size(); ++j) {
      std::string name;
      for (const char letter : plots[i].curves[j].name)
        if (letter != '"' && letter != '\\' && letter != '<' && static_cast<unsigned char>(letter) >= 32)
          name += letter;
      out += fmt::format("{}{{\"name\":\"{}\",\"look\":\"{}\",\"values\":{}}}", j ? "," : "", name,
                         plots[i].curves[j].look, list(plots[i].curves[j].values));
    }
    out += "]";
  }
  return out + "]}";
}

std::string no_series() { return "{\"distance\":[0],\"time\":[0],\"plots\":[]}"; }

}  // namespace apc::report
