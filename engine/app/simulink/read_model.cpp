#include "engine/app/simulink/read_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string_view>

#include "engine/app/simulink/plain_text.hpp"
#include "engine/base/archive/archive.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/inside.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::simulink {
namespace {

using pugi::xml_node;

constexpr int max_depth = 60;  // systems in systems
constexpr std::size_t max_blocks = 200'000;

[[noreturn]] void refuse(const std::string& path, const std::string& sentence) {
  throw yaml::Error(yaml::Fault{{path, {}}, "", yaml::Message(sentence), {}});
}

/// Returns the texts of <P Name="..">..</P> below a node.
void add_texts(const xml_node& node, Texts& texts) {
  for (const xml_node& p : node.children("P")) texts[p.attribute("Name").value()] = p.text().get();
}

LineEnd line_end(const std::string& text) {
  const std::size_t mark = text.find('#');
  if (mark == text.npos) return {text, ""};
  std::string port = text.substr(mark + 1);
  if (port.find(':') == port.npos && (port == "in" || port == "out")) port += ":1";
  return {text.substr(0, mark), port};
}

/// Reader of the files of one archive.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), archive_(path, "Simulink model") {}

  Model read() {
    Model model;
    model.name = std::filesystem::path(path_).stem().string();
    const std::string main = "simulink/blockdiagram.xml";
    if (!archive_.contains(main))
      refuse(path_, "has no simulink/blockdiagram.xml; a Simulink model of R2012a or later has one");
    const pugi::xml_document document = parsed(main);
    const xml_node root = model_node(document);
    add_texts(root, model.texts);
    add_defaults(root.child("BlockParameterDefaults"), model);
    read_file("simulink/bddefaults.xml", [&](const xml_node& top) {
      add_defaults(
          top.name() == std::string("BlockParameterDefaults") ? top : top.child("BlockParameterDefaults"),
          model);
    });
    read_configuration(root, model);
    const xml_node system = system_of(root);
    if (!system) refuse(path_, "has no <System>, in which the blocks of a model are");
    read_system(system, model.root, 0);
    model.notes = notes_;
    return model;
  }

 private:
  pugi::xml_document parsed(const std::string& name) const {
    const std::string text = archive_.read(name);
    pugi::xml_document document;
    const pugi::xml_parse_result result =
        document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_doctype);
    if (!result)
      refuse(path_, fmt::format("has a damaged {}: {} (byte {})", name, result.description(), result.offset));
    for (const xml_node& node : document.children())
      if (node.type() == pugi::node_doctype)
        refuse(path_,
               fmt::format("has a document type in {}, which Simulink never writes; nothing of it is read",
                           name));
    return document;
  }

  template <class Use>
  void read_file(const std::string& name, const Use& use) const {
    if (!archive_.contains(name)) return;
    const pugi::xml_document document = parsed(name);
    use(document.document_element());
  }

  xml_node model_node(const pugi::xml_document& document) const {
    const xml_node top = document.document_element();
    if (const xml_node node = top.child("Model")) return node;
    if (top.child("Library"))
      refuse(path_, "is a library of blocks, and no model; import a model that uses its blocks");
    refuse(path_, "has no <Model> in simulink/blockdiagram.xml");
  }

  static void add_defaults(const xml_node& node, Model& model) {
    for (const xml_node& block : node.children("Block"))
      add_texts(block, model.defaults[block.attribute("BlockType").value()]);
  }

  /// Reads the solver from the configurations, which are in the model's file or in files of their own.
  void read_configuration(const xml_node& root, Model& model) {
    std::vector<std::string> files;
    for (const std::string& name : archive_.names())
      if (name.starts_with("simulink/configSet") && name.ends_with(".xml") &&
          name != "simulink/configSetInfo.xml")
        files.push_back(name);
    std::size_t found = add_solvers(root, model);
    for (const std::string& name : files)
      read_file(name, [&](const xml_node& top) { found += add_solvers(top, model); });
    if (found > 1)
      notes_.push_back(fmt::format("the model has {} configurations; the first one is used", found));
  }

  /// Adds the texts of a solver, and of the parts of its configuration on initial states and on messages.
  static void add_configuration(const xml_node& solver, Texts& texts) {
    add_texts(solver, texts);
    for (const xml_node& part : solver.parent().children("Object")) {
      const std::string_view type = part.attribute("ClassName").value();
      if (type != "Simulink.DataIOCC" && type != "Simulink.DebuggingCC") continue;
      Texts more;
      add_texts(part, more);
      texts.merge(more);
    }
  }

  /// Adds the first solver of a tree, and returns how many there are.
  static std::size_t add_solvers(const xml_node& root, Model& model) {
    std::size_t found = 0;
    struct Walker : pugi::xml_tree_walker {
      std::vector<xml_node> solvers;
      bool for_each(xml_node& node) override {
        if (node.name() == std::string_view("Object") &&
            node.attribute("ClassName").value() == std::string_view("Simulink.SolverCC"))
          solvers.push_back(node);
        return true;
      }
    } walker;
    xml_node top = root;
    top.traverse(walker);
    for (const xml_node& node : walker.solvers) {
      if (model.solver.empty()) add_configuration(node, model.solver);
      ++found;
    }
    return found;
  }

  /// Returns the node that has the content of a system: <System> itself, or that of the file it refers to.
  xml_node system_of(const xml_node& owner) {
    const xml_node node = owner.child("System");
    const std::string reference = node.attribute("Ref").value();
    if (reference.empty()) return node;
    const std::string name = "simulink/systems/" + reference + ".xml";
    if (!archive_.contains(name))
      refuse(path_, fmt::format("refers to the system '{}', and has no {}", reference, name));
    if (!visited_.insert(name).second)
      refuse(path_, fmt::format("refers to {} twice; systems form a tree", name));
    files_.push_back(std::make_unique<pugi::xml_document>(parsed(name)));
    const xml_node top = files_.back()->document_element();
    return top.name() == std::string_view("System") ? top : top.child("System");
  }

  void read_system(const xml_node& node, System& into, int depth) {
    if (depth > max_depth)
      refuse(path_, fmt::format("has systems in each other more than {} deep", max_depth));
    for (const xml_node& block : node.children("Block")) {
      if (++blocks_ > max_blocks) refuse(path_, fmt::format("has more than {} blocks", max_blocks));
      into.blocks.push_back(read_block(block, depth));
    }
    for (const xml_node& line : node.children("Line")) read_line(line, into);
    for (const xml_node& annotation : node.children("Annotation")) read_annotation(annotation, into);
  }

  Block read_block(const xml_node& node, int depth) {
    Block block;
    block.type = node.attribute("BlockType").value();
    block.name = on_one_line(node.attribute("Name").value());
    block.sid = node.attribute("SID").value();
    if (block.sid.empty()) block.sid = "name " + block.name;
    add_texts(node, block.texts);
    add_texts(node.child("InstanceData"), block.texts);
    for (const xml_node& array : node.children("Array"))
      if (const xml_node cell = array.child("Cell"))
        block.texts[array.attribute("PropName").value()] = cell.text().get();
    read_ports(node, block);
    read_mask(node, block);
    if (node.child("System")) {
      block.system = std::make_unique<System>();
      read_system(system_of(node), *block.system, depth + 1);
    }
    return block;
  }

  static void read_ports(const xml_node& node, Block& block) {
    for (const char* group : {"PortProperties", "Ports"})
      for (const xml_node& port : node.child(group).children("Port")) read_port(port, block);
    for (const xml_node& port : node.children("Port")) read_port(port, block);
    const xml_node counts = node.child("PortCounts");
    for (const pugi::xml_attribute& count : counts.attributes())
      block.texts[std::string("PortCounts.") + count.name()] = count.value();
  }

  static void read_port(const xml_node& node, Block& block) {
    if (node.attribute("Type") && node.attribute("Type").value() != std::string_view("out")) return;
    Texts texts;
    add_texts(node, texts);
    int number = node.attribute("Index").as_int(0);
    if (number == 0 && texts.contains("PortNumber")) number = std::atoi(texts["PortNumber"].c_str());
    const auto name = texts.find("Name");
    if (number > 0 && name != texts.end() && !name->second.empty())
      block.output_names[number] = on_one_line(name->second);
  }

  /// Returns the value of a mask's parameter. An evaluated choice is its number in the list, a box 1 or 0.
  static std::string mask_value(const xml_node& parameter) {
    const std::string text = parameter.child("Value").text().get(),
                      type = parameter.attribute("Type").value();
    if (std::string_view(parameter.attribute("Evaluate").value()) == "off") return text;
    std::vector<std::string> choices;
    for (const xml_node& option : parameter.child("TypeOptions").children("Option"))
      choices.emplace_back(option.text().get());
    return type == "checkbox" ? box_value(text) : type == "popup" ? number_of_choice(text, choices) : text;
  }
  static std::string box_value(const std::string& text) {
    return text == "on" ? "1" : text == "off" ? "0" : text;
  }
  static std::string number_of_choice(const std::string& text, const std::vector<std::string>& choices) {
    const auto found = std::ranges::find(choices, text);
    return found == choices.end() ? text : std::to_string(found - choices.begin() + 1);
  }

  static void read_mask(const xml_node& node, Block& block) {
    const xml_node mask = node.child("Mask");
    block.mask_code = mask.child("Initialization").text().get();
    for (const xml_node& parameter : mask.children("MaskParameter"))
      block.mask.emplace_back(parameter.attribute("Name").value(), mask_value(parameter));
    if (mask) return;
    read_old_mask(block);
  }

  /// Reads a mask of the form of R2012: MaskVariables "a=@1;b=@2;" and MaskValueString "1|2".
  static void read_old_mask(Block& block) {
    const auto names = block.texts.find("MaskVariables");
    const auto values = block.texts.find("MaskValueString");
    if (block.texts.contains("MaskInitialization")) block.mask_code = block.texts["MaskInitialization"];
    if (names == block.texts.end() || values == block.texts.end()) return;
    const std::vector<std::string> variables = parts_of(names->second, ';'),
                                   texts = parts_of(values->second, '|'),
                                   styles = parts_of(block.texts["MaskStyleString"], ',');
    for (std::size_t i = 0; i < std::min(variables.size(), texts.size()); ++i) {
      const std::string style = i < styles.size() ? styles[i] : "edit";
      const bool is_evaluated = variables[i].find("=&") == std::string::npos;
      block.mask.emplace_back(variables[i].substr(0, variables[i].find('=')),
                              is_evaluated ? old_mask_value(texts[i], style) : texts[i]);
    }
  }
  static std::string old_mask_value(const std::string& text, const std::string& style) {
    if (style == "checkbox") return box_value(text);
    if (!style.starts_with("popup(")) return text;
    return number_of_choice(text, parts_of(style.substr(6, style.size() - 7), '|'));
  }

  void read_line(const xml_node& node, System& into) const {
    Texts texts;
    add_texts(node, texts);
    Line line;
    line.name = texts["Name"];
    line.source = texts.contains("SrcBlock")
                      ? LineEnd{"name " + on_one_line(texts["SrcBlock"]), old_port("out:", texts["SrcPort"])}
                      : line_end(texts["Src"]);
    add_sinks(node, line, 0);
    if (!line.source.sid.empty()) into.lines.push_back(std::move(line));
  }

  static std::string old_port(const std::string& kind, const std::string& port) {
    const bool is_number = !port.empty() && std::isdigit(static_cast<unsigned char>(port[0]));
    return port.empty() ? kind + "1" : is_number ? kind + port : port;
  }

  void add_sinks(const xml_node& node, Line& line, int depth) const {
    if (depth > 1000) refuse(path_, "has a line with more than 1000 branches in each other");
    Texts texts;
    add_texts(node, texts);
    if (texts.contains("DstBlock"))
      line.sinks.push_back({"name " + on_one_line(texts["DstBlock"]), old_port("in:", texts["DstPort"])});
    if (texts.contains("Dst")) line.sinks.push_back(line_end(texts["Dst"]));
    for (const xml_node& branch : node.children("Branch")) add_sinks(branch, line, depth + 1);
  }

  static void read_annotation(const xml_node& node, System& into) {
    Texts texts;
    add_texts(node, texts);
    std::string text = texts["Name"].empty() ? node.attribute("Name").value() : texts["Name"];
    text = without_markup(texts.contains("PlainText") ? texts["PlainText"] : text);
    if (!text.empty()) into.annotations.push_back(text);
  }

  std::string path_;
  archive::Archive archive_;
  std::vector<std::unique_ptr<pugi::xml_document>> files_;  ///< of systems; nodes refer to them
  std::set<std::string> visited_;
  std::size_t blocks_ = 0;
  std::vector<std::string> notes_;
};

/// Refuses models in the text format of Simulink.
void refuse_text_format(const std::string& path) {
  io::require_inside(path);
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) refuse(path, "there is no such file");
  std::ifstream file(path, std::ios::binary);
  std::string start(2048, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  if (start.starts_with("PK")) return;
  if (path.ends_with(".mdl") || start.find("Model {") != start.npos || start.find("Library {") != start.npos)
    refuse(path, "is a model in the old text format; save it as .slx in Simulink and import that");
}

}  // namespace

Model read_model(const std::string& path) {
  refuse_text_format(path);
  try {
    return Reader(path).read();
  } catch (const archive::ArchiveError& error) {
    std::string text = error.what();
    if (text.starts_with(path + " ")) text = text.substr(path.size() + 1);
    refuse(path, text);
  }
}

}  // namespace stepwire::simulink
