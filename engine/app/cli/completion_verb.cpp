#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/choice.hpp"
#include "engine/app/cli/completion.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/verb.hpp"

namespace stepwire::cli {

namespace {

using Script = std::string (*)(const VerbWords& program, const std::vector<VerbWords>& verbs);

Script script_for(const std::string& shell) {
  if (shell == "bash") return bash_completion;
  return shell == "zsh" ? zsh_completion : fish_completion;
}

Action declare_completion(CLI::App& verb) {
  const auto shell = std::make_shared<std::string>();
  verb.add_option("SHELL", *shell, "the shell")->required()->check(Choice({"bash", "zsh", "fish"}));
  return [shell, program = verb.get_parent()](const Registry&) {
    put_data(script_for(*shell)(program_words(*program), verb_words(*program)));
    return ExitCode::done;
  };
}

}  // namespace

Verb completion_verb() {
  return {"completion", "print the script by which a shell completes calls of stepwire",
          "Example:\n  source <(stepwire completion bash)", declare_completion};
}

}  // namespace stepwire::cli
