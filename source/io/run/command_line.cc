// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_names.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/shell_word.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/io/run/command_line.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace contrecoup
{
namespace io
{
  namespace
  {
    const std::vector<std::string> options = {"--set",
                                              "--output",
                                              "--resume",
                                              "--overwrite",
                                              "--check",
                                              "--estimate",
                                              "--print-parameters",
                                              "--verbose",
                                              "--help",
                                              "--version"};

    bool takes_value(const std::string &option)
    {
      return option == "--set" || option == "--output";
    }

    /// Also with the form behind "=".
    bool prints_parameters(const std::string &option)
    {
      return option.substr(0, option.find('=')) == "--print-parameters";
    }

    void apply(const std::string &option,
               const std::string &value,
               CommandLine &command)
    {
      if (option == "--set")
        command.overrides.push_back(value);
      else if (option == "--output")
        command.output_folder = value;
      else if (option == "--resume")
        command.resume = true;
      else if (option == "--overwrite")
        command.overwrite = true;
      else if (option == "--check")
        command.check = true;
      else if (option == "--estimate")
        command.estimate = true;
      else if (option == "--print-parameters")
      {
        command.print_parameters = true;
        if (!value.empty() && value != "json")
          throw InputError("--print-parameters cannot write \"" + value +
                           "\"; allowed: json, or nothing for a text");
        if (!value.empty())
          command.form = ParameterForm::json;
      }
      else if (option == "--verbose")
        command.verbose = true;
      else if (option == "--help" || option == "-h")
        command.help = true;
      else if (option == "--version")
        command.version = true;
      else
        throw InputError("unknown option \"" + option + "\"" +
                         suggestion(option, options));
    }

    bool is_file_name(const std::string &word)
    {
      std::error_code ignored;
      return std::filesystem::path(word).extension() == ".prm" ||
             std::filesystem::is_regular_file(word, ignored);
    }

    void accept_file(const std::string &file, CommandLine &command)
    {
      if (command.print_parameters && command.wanted_parameters.empty() &&
          !is_file_name(file))
      {
        command.wanted_parameters = file;
        return;
      }
      if (!command.parameter_file.empty())
        throw InputError("two parameter files are given, \"" +
                         command.parameter_file + "\" and \"" + file +
                         "\"; only --check takes several");
      command.parameter_file = file;
    }

    /// @return possible oversights of the user, one line each
    std::vector<std::string> assign(const CommandLine &command,
                                    dealii::ParameterHandler &prm)
    {
      const std::vector<Assignment> assignments = assignments_of(command, prm);
      apply_assignments(assignments, prm);
      return find_oversights(command.parameter_file, assignments);
    }
  } // namespace

  std::vector<std::vector<std::string>>
  single_commands(const std::vector<std::string> &arguments)
  {
    std::vector<std::string> files, options;
    bool checks = false, only_prints = false;
    for (std::size_t i = 0; i < arguments.size(); ++i)
    {
      const std::string &word = arguments[i];
      const bool is_option = !word.empty() && word[0] == '-';
      (i > 0 && !is_option ? files : options).push_back(word);
      if (takes_value(word) && i + 1 < arguments.size())
        options.push_back(arguments[++i]);
      checks = checks || word == "--check";
      only_prints = only_prints || word == "--help" || word == "-h" ||
                    word == "--version" || prints_parameters(word);
    }
    if (!checks || only_prints || files.size() < 2)
      return {arguments};
    std::vector<std::vector<std::string>> commands;
    for (const std::string &file : files)
    {
      commands.push_back(options);
      commands.back().push_back(file);
    }
    return commands;
  }

  int run_each(
    const std::vector<std::string> &arguments,
    const std::function<Failure(const std::vector<std::string> &)> &work,
    const bool writes_output)
  {
    const auto commands = single_commands(arguments);
    Log::instance().set_verbose(std::find(arguments.begin(),
                                          arguments.end(),
                                          "--verbose") != arguments.end());
    int code = 0;
    for (const std::vector<std::string> &command : commands)
    {
      const std::string file = commands.size() > 1 ? command.back() : "";
      if (writes_output && !file.empty())
        std::cout << file << ":" << std::endl;
      const Failure failure = work(command);
      if (is_stop(failure))
      {
        // Runs say where they were stopped.
        if (writes_output &&
            std::find(command.begin(), command.end(), "--check") !=
              command.end())
          std::cout << failure.message << std::endl;
        return static_cast<int>(failure.code);
      }
      code = std::max(code, static_cast<int>(failure.code));
      if (!writes_output || failure.code == ExitCode::done)
        continue;
      const bool names_it = failure.message.find(file) != std::string::npos;
      std::cerr << "error: " << (names_it ? "" : file + ": ") << failure.message
                << std::endl;
    }
    return code;
  }

  CommandLine parse_command_line(const int argc,
                                 const char *const *argv,
                                 const std::string &application)
  {
    CommandLine command;
    for (int i = 1; i < argc; ++i)
    {
      std::string word = argv[i];
      if (word.empty() || word[0] != '-')
      {
        accept_file(word, command);
        continue;
      }
      std::string value;
      const std::size_t equals = word.find('=');
      if (equals != std::string::npos &&
          (takes_value(word.substr(0, equals)) || prints_parameters(word)))
      {
        value = word.substr(equals + 1);
        word = word.substr(0, equals);
      }
      else if (takes_value(word) && i + 1 < argc)
        value = argv[++i];
      if (takes_value(word) && value.empty())
        throw InputError(
          "the option " + word + " needs a value" +
          (word == "--set" ? ", \"Section/Entry=value\"" : ", a folder"));
      apply(word, value, command);
    }
    const bool only_prints =
      command.help || command.version || command.print_parameters;
    if (command.parameter_file.empty() && !only_prints)
      throw InputError("no parameter file is given; --help shows how");
    if (command.estimate && application != "scene")
      throw InputError("the option --estimate is one of scene, not of " +
                       application);
    if (command.resume && command.overwrite)
      throw InputError("--resume keeps what --overwrite removes; give one of "
                       "them");
    if (command.output_folder.empty())
      command.output_folder =
        "output/" + application + "/" +
        std::filesystem::path(command.parameter_file).stem().string();
    return command;
  }

  std::string help_text(const std::string &application,
                        const std::string &purpose,
                        const std::string &parallel)
  {
    const std::string estimate =
      "  --estimate          prints a first answer from tables, without a run\n";
    return application + ": " + purpose + "\n\n  " + application +
           " FILE.prm [options]\n  " + application +
           " --check FILE.prm FILE.prm ... [options]\n\n"
           "  --set \"Section/Subsection/Entry=value\"\n"
           "                      overrides one entry of the file; any number "
           "of times\n"
           "  --output DIR        the output folder (default: output/" +
           application +
           "/<name of FILE>)\n"
           "  --resume            goes on from the last complete checkpoint "
           "there\n"
           "  --overwrite         begins anew and removes what an earlier run "
           "left there\n"
           "  --check             says what would be run and what it would "
           "cost\n" +
           (application == "scene" ? estimate : "") +
           "  --print-parameters[=json] [WORD]\n"
           "                      prints all entries with meaning, allowed "
           "values, default;\n"
           "                      with WORD a section, such as Time or "
           "Output, or\n"
           "                      the entries whose name or meaning has it;\n"
           "                      =json prints them for programs\n"
           "  --verbose           shows on the screen what log.txt gets\n"
           "  --help              prints this\n"
           "  --version           prints version and git revision\n\n"
           "Exit codes: 0 done, 1 bad input, 2 the numerics failed, 3 the "
           "system failed;\n130, 143, 138 stopped by Ctrl-C, SIGTERM, SIGUSR1, "
           "with a checkpoint to go on\nfrom.\n" +
           parallel;
  }

  std::string requested_text(
    const CommandLine &command,
    const std::string &application,
    const std::string &purpose,
    const std::string &parallel,
    const std::function<void(dealii::ParameterHandler &)> &declare_parameters)
  {
    if (command.help)
      return help_text(application, purpose, parallel);
    if (command.version)
      return application + " " + version() + " (" + git_revision() + ")";
    if (!command.print_parameters)
      return "";
    dealii::ParameterHandler prm;
    declare_parameters(prm);
    std::string comments = "# " + application + ": " + purpose + "\n";
    for (const std::string &line : assign(command, prm))
      comments += "# " + line + "\n";
    const std::string found =
      find_parameters(prm, command.wanted_parameters, command.form);
    return command.form == ParameterForm::json ? found
                                               : comments + "\n" + found;
  }

  void print_requested(const std::string &text)
  {
    std::cout << text << std::endl;
    if (!std::cout)
      throw SystemError(
        "cannot write to the standard output: is the disk full?");
  }

  void read_parameters(const CommandLine &command,
                       dealii::ParameterHandler &prm)
  {
    for (const std::string &line : assign(command, prm))
      show_line(line);
  }


  void warn_of_unused(const CommandLine &command,
                      const dealii::ParameterHandler &prm)
  {
    // Entries that a program has set are in no file.
    if (!std::filesystem::exists(command.parameter_file))
      return;
    for (const std::string &line :
         find_unused(prm, assignments_of(command, prm)))
      show_line(line);
  }


  std::string repeating_command(const CommandLine &command,
                                const unsigned int ranks)
  {
    std::error_code ignored;
    const std::string program =
      std::filesystem::read_symlink("/proc/self/exe", ignored).string();
    std::string text =
      "cd " + shell_word(std::filesystem::current_path(ignored).string()) +
      " && ";
    if (ranks > 1)
      text += "mpirun -np " + std::to_string(ranks) + " ";
    text += shell_word(program) + " " + shell_word(command.parameter_file);
    for (const std::string &override : command.overrides)
      text += " --set " + shell_word(override);
    return text + " --output " + shell_word(command.output_folder);
  }


  std::vector<Assignment> assignments_of(const CommandLine &command,
                                         const dealii::ParameterHandler &prm)
  {
    std::vector<Assignment> assignments;
    if (!command.parameter_file.empty())
      assignments = read_assignments(command.parameter_file);
    for (const std::string &text : command.overrides)
      assignments.push_back(parse_override(text));
    return with_declared_names(assignments, prm);
  }
} // namespace io
} // namespace contrecoup
