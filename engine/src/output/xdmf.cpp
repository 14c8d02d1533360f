#include "xdmf.hpp"

#include <fmt/format.h>

namespace shoreline {
namespace {

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    if (c == '&')
      xml += "&amp;";
    else if (c == '<')
      xml += "&lt;";
    else if (c == '>')
      xml += "&gt;";
    else if (c == '"')
      xml += "&quot;";
    else if (static_cast<unsigned char>(c) < 0x20)  // XML has no way to write most of them
      xml += ' ';
    else
      xml += c;
  }
  return xml;
}

std::string array(const std::string& path, const std::string& shape, const std::string& type) {
  return fmt::format(R"(<DataItem Format="HDF" {} Dimensions="{}">results.h5:{}</DataItem>)", type, shape,
                     escaped(path));
}

std::string numbers(const std::string& path, const std::string& shape) {
  return array(path, shape, R"(NumberType="Float" Precision="8")");
}

std::string cells(const char* type, Eigen::Index count, Eigen::Index nodes, const std::string& table) {
  return fmt::format(R"(<Topology TopologyType="{}" NumberOfElements="{}" NodesPerElement="{}">{}</Topology>)", type,
                     count, nodes,
                     array(table, fmt::format("{} {}", count, nodes), R"(NumberType="Int" Precision="4")"));
}

std::string geometry(const std::string& path, Eigen::Index points) {
  return fmt::format(R"(<Geometry GeometryType="XYZ">{}</Geometry>)", numbers(path, fmt::format("{} 3", points)));
}

std::string attribute(const char* name, const char* type, const std::string& path, const std::string& shape) {
  return fmt::format(R"(<Attribute Name="{}" AttributeType="{}" Center="Node">{}</Attribute>)", name, type,
                     numbers(path, shape));
}

std::string file_of(const std::string& grids) {
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\"><Domain>\n" + grids + "</Domain></Xdmf>\n";
}

std::string time(const SavedStep& step) { return fmt::format(R"(<Time Value="{}"/>)", step.t); }

}  // namespace

std::string step_group(const SavedStep& step) { return fmt::format("/steps/{:06}", step.step); }

std::string link_name(const std::string& name) {
  if (name.empty() || name == ".") return name.empty() ? "%" : "%2E";
  std::string link;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || c == '/' || c == ':' || c == '%' || c == '|')
      link += fmt::format("%{:02X}", byte);
    else
      link += c;
  }
  return link;
}

std::string vertices_table(Eigen::Index points) { return fmt::format("/connectivity/vertices {}", points); }

std::string line_table(Eigen::Index points) { return fmt::format("/connectivity/line {}", points); }

std::string triangle_table() { return "/connectivity/triangles"; }

bool saves_strain(const SavedStep& step, const MaterialPoints& points) {
  return step.strain || points.strain.cols() > 0;
}

std::string point_grid(const SavedStep& step, const MaterialPoints& points) {
  const Eigen::Index n = points.size();
  const std::string group = step_group(step) + "/points/";
  const std::string velocity =
      step.velocity ? attribute("velocity", "Vector", group + "velocity", fmt::format("{} 3", n)) + "\n" : "";
  const std::string strain =
      saves_strain(step, points)
          ? attribute("strain (xx, yy, xy)", "Matrix", group + "strain", fmt::format("{} 3", n)) + "\n"
          : "";
  const std::string estimate =
      step.stress_error_estimate
          ? attribute("stress_error_estimate", "Scalar", group + "stress_error_estimate", fmt::format("{}", n)) + "\n"
          : "";
  return "<Grid Name=\"material points\" GridType=\"Uniform\">" + time(step) + "\n" +
         cells("Polyvertex", n, 1, vertices_table(n)) + "\n" + geometry(group + "position", n) + "\n" +
         attribute("displacement", "Vector", group + "displacement", fmt::format("{} 3", n)) + "\n" + velocity +
         estimate + attribute("stress (xx, yy, xy, zz)", "Matrix", group + "stress", fmt::format("{} 4", n)) + "\n" +
         strain + attribute("volume", "Scalar", group + "volume", fmt::format("{}", n)) + "\n</Grid>\n";
}

std::string curve_grid(const SavedStep& step) {
  if (step.curves.empty()) return "";
  std::string grids = "<Grid Name=\"boundary\" GridType=\"Collection\" CollectionType=\"Spatial\">" + time(step) + "\n";
  for (const SavedStep::Curve& curve : step.curves) {
    const Eigen::Index m = curve.polyline.cols();
    grids += fmt::format("<Grid Name=\"{}\" GridType=\"Uniform\">", escaped(curve.name)) +
             cells("Polyline", 1, m, line_table(m)) +
             geometry(step_group(step) + "/curves/" + link_name(curve.name) + "/polyline", m) + "</Grid>\n";
  }
  return grids + "</Grid>\n";
}

std::string xdmf(const std::string& curve_grids, const std::string& point_grids) {
  const auto in_time = [](const char* name, const std::string& grids) {
    return fmt::format("<Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n{}</Grid>\n", name,
                       grids);
  };
  return file_of((curve_grids.empty() ? "" : in_time("boundary", curve_grids)) +
                 in_time("material points", point_grids));
}

std::string xdmf(const SampledField& field) {
  const Eigen::Index n = field.value.size();
  const auto scalar = [n](const char* name) {
    return attribute(name, "Scalar", std::string("/field/") + name, fmt::format("{}", n)) + "\n";
  };
  return file_of("<Grid Name=\"field\" GridType=\"Uniform\">\n" +
                 cells("Triangle", field.triangle.cols(), 3, triangle_table()) + "\n" + geometry("/field/position", n) +
                 "\n" + scalar("value") + (field.error ? scalar("error") : "") + "</Grid>\n");
}

}  // namespace shoreline
