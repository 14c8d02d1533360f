#include "shoreline/bases/gmsh_reader.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>
#include <unordered_map>

namespace shoreline {
namespace {

/// A word of a file as messages show it: short, and nothing that is no text.
std::string shown(std::string_view word) {
  constexpr std::size_t most = 40;
  std::string text = "\"";
  for (const char c : word.substr(0, most)) text += c > ' ' && c <= '~' ? c : '?';
  return text + (word.size() > most ? "...\"" : "\"");
}

/// The lines of a file with words in them, one at a time, and the words of the current one.
class Lines {
 public:
  Lines(std::istream& in, const std::string& name) : in_(in), name_(name) {}

  /// Moves on; false at the end of the file.
  bool next() {
    while (std::getline(in_, line_)) {
      ++number_;
      rest_ = line_;
      if (rest_.find_first_not_of(blank) != std::string_view::npos) return true;
    }
    ++number_;
    rest_ = {};
    return false;
  }
  void require_next(const std::string& expected) {
    if (!next()) fail("the file ends, expected " + expected);
  }
  /// Takes the next word of the line; empty if there is none.
  std::string_view word() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blank), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(blank));
    rest_.remove_prefix(word.size());
    return word;
  }
  template <class Number>
  Number number(const std::string& what) {
    const std::string_view found = word();
    Number value{};
    const auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (found.empty() || error != std::errc{} || end != found.data() + found.size())
      fail("expected " + what + ", found " + shown(found));
    return value;
  }
  void require_end() {
    if (const std::string_view more = word(); !more.empty()) fail("expected the end of the line, found " + shown(more));
  }
  void require_line(const std::string& keyword) {
    require_next(keyword);
    if (const std::string_view found = word(); found != keyword)
      fail("expected " + keyword + ", found " + shown(found));
    require_end();
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw MeshError(name_ + ":" + std::to_string(number_) + ": " + problem);
  }

 private:
  static constexpr std::string_view blank = " \t\r";
  std::istream& in_;
  const std::string& name_;
  std::string line_;
  std::string_view rest_;
  long number_ = 0;
};

using Tag = long long;

/// The mesh so far, with the nodes by the file's tags.
struct Contents {
  bool blocks;  ///< format 4.1: nodes and elements come in blocks
  std::unordered_map<Tag, Vec2> node;
  std::unordered_map<Tag, Index> vertex_of;
  TriangleMesh mesh;
};

bool read_format(Lines& lines) {
  lines.require_line("$MeshFormat");
  lines.require_next("the version of the format");
  const std::string version(lines.word());
  if (version != "2.2" && version != "4.1")
    lines.fail("format " + shown(version) + " is not read, save the mesh in format 2.2 or 4.1 (Mesh.MshFileVersion)");
  if (lines.number<int>("0 for ASCII or 1 for binary") != 0)
    lines.fail("the file is binary, save the mesh as ASCII (Mesh.Binary = 0)");
  lines.require_line("$EndMeshFormat");
  return version == "4.1";
}

long count(Lines& lines, const std::string& what) {
  const long n = lines.number<long>(what);
  if (n < 0) lines.fail("expected " + what + ", found " + std::to_string(n));
  return n;
}

void read_position(Lines& lines, Contents& contents, Tag tag) {
  const double x = lines.number<double>("a coordinate x");
  const double y = lines.number<double>("a coordinate y");
  const double z = lines.number<double>("a coordinate z");
  lines.require_end();
  if (z != 0.0) lines.fail("node " + std::to_string(tag) + " is not in the plane z = 0");
  if (!contents.node.emplace(tag, Vec2(x, y)).second) lines.fail("a second node " + std::to_string(tag));
}

void read_nodes(Lines& lines, Contents& contents) {
  lines.require_next("the number of nodes");
  const long parts = count(lines, contents.blocks ? "the number of blocks of nodes" : "the number of nodes");
  for (long part = 0; part < parts; ++part) {
    lines.require_next("a node");
    if (!contents.blocks) {
      const Tag tag = lines.number<Tag>("the tag of a node");
      read_position(lines, contents, tag);
      continue;
    }
    lines.number<int>("the dimension of an entity");
    lines.number<Tag>("the tag of an entity");
    if (lines.number<int>("0 for nodes without parameters") != 0)
      lines.fail("nodes with parameters are not read, save without them (Mesh.SaveParametric = 0)");
    const long nodes = count(lines, "the number of nodes in the block");
    std::vector<Tag> tags;
    for (long k = 0; k < nodes; ++k) {
      lines.require_next("the tag of a node");
      tags.push_back(lines.number<Tag>("the tag of a node"));
      lines.require_end();
    }
    for (const Tag tag : tags) {
      lines.require_next("a position");
      read_position(lines, contents, tag);
    }
  }
  lines.require_line("$EndNodes");
}

Index vertex(Lines& lines, Contents& contents) {
  const Tag tag = lines.number<Tag>("the tag of a node");
  const auto node = contents.node.find(tag);
  if (node == contents.node.end()) lines.fail("there is no node " + std::to_string(tag));
  const auto next = static_cast<Index>(contents.mesh.vertex.size());
  const auto [found, is_new] = contents.vertex_of.emplace(tag, next);
  if (is_new) contents.mesh.vertex.push_back(node->second);
  return found->second;
}

/// Whether elements of a type are triangles; false if they may be passed over.
bool are_triangles(const Lines& lines, int type) {
  static const std::map<int, std::string> refused{{3, "quadrangles"}, {9, "triangles of six nodes"}};
  if (type == 2) return true;
  if (type == 1 || type == 15 || type == 8) return false;  // lines, points, lines of three nodes
  const auto known = refused.find(type);
  lines.fail("elements of type " + std::to_string(type) + (known == refused.end() ? "" : ", " + known->second) +
             ", are not read; mesh the plane with triangles of three nodes (type 2)");
}

void read_element(Lines& lines, Contents& contents, bool triangle) {
  if (!triangle) return;
  std::array<Index, 3> vertices{};
  for (Index& v : vertices) v = vertex(lines, contents);
  lines.require_end();
  contents.mesh.triangle.push_back(vertices);
}

void read_elements(Lines& lines, Contents& contents) {
  lines.require_next("the number of elements");
  const long parts = count(lines, contents.blocks ? "the number of blocks of elements" : "the number of elements");
  for (long part = 0; part < parts; ++part) {
    lines.require_next("an element");
    lines.number<Tag>(contents.blocks ? "the dimension of an entity" : "the tag of an element");
    if (contents.blocks) lines.number<Tag>("the tag of an entity");
    const bool triangle = are_triangles(lines, lines.number<int>("the type of an element"));
    const long n = count(lines, contents.blocks ? "the number of elements in the block" : "the number of tags");
    if (!contents.blocks) {
      for (long k = 0; k < n; ++k) lines.number<Tag>("a tag");
      read_element(lines, contents, triangle);
      continue;
    }
    for (long k = 0; k < n; ++k) {
      lines.require_next("an element");
      lines.number<Tag>("the tag of an element");
      read_element(lines, contents, triangle);
    }
  }
  lines.require_line("$EndElements");
}

void pass_over(Lines& lines, const std::string& section) {
  const std::string end = "$End" + section.substr(1);
  do lines.require_next(end);
  while (lines.word() != end);
}

}  // namespace

TriangleMesh read_gmsh(std::istream& in, const std::string& name) {
  Lines lines(in, name);
  Contents contents{};
  contents.blocks = read_format(lines);
  while (lines.next()) {
    const std::string section(lines.word());
    if (section == "$Nodes")
      read_nodes(lines, contents);
    else if (section == "$Elements")
      read_elements(lines, contents);
    else if (section == "$PhysicalNames" || section == "$Entities" || section == "$Comments")
      pass_over(lines, section);
    else
      lines.fail(shown(section) + " is not read; expected $Nodes, $Elements, $PhysicalNames, $Entities or $Comments");
  }
  if (contents.mesh.triangle.empty()) lines.fail("the file ends and had no triangles");
  return contents.mesh;
}

}  // namespace shoreline
