/// Runs the real program in a folder of its own and keeps what it said.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace apc::scenarios {

struct Said {
  int exit_code = -1;
  std::string out, err;
  std::size_t error_lines() const { return static_cast<std::size_t>(std::count(err.begin(), err.end(), '\n')); }
};

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// An empty folder that vanishes with the test.
class Folder {
 public:
  Folder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("apc_scenario_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return name;
  }
  /// Everything in it, as paths relative to it.
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_))
      names.insert(entry.path().lexically_relative(path_).generic_string());
    return names;
  }

 private:
  std::filesystem::path path_;
};

/// Starts the program in `folder`; its output goes to files outside of it.
class Running {
 public:
  Running(const Folder& folder, std::vector<std::string> words)
      : out_(folder.path().string() + ".out"), err_(folder.path().string() + ".err") {
    words.insert(words.begin(), APC_PROGRAM);
    child_ = ::fork();
    if (child_ != 0) return;
    if (::chdir(folder.path().c_str()) != 0) ::_exit(126);
    const auto redirect = [](const std::string& path, int to) {
      const int file = ::open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
      ::dup2(file, to);
      ::close(file);
    };
    redirect(out_, STDOUT_FILENO);
    redirect(err_, STDERR_FILENO);
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(APC_PROGRAM, arguments.data());
    ::_exit(127);
  }
  void interrupt() const { ::kill(child_, SIGINT); }
  void kill() const { ::kill(child_, SIGKILL); }
  bool ended() {
    if (!waited_ && ::waitpid(child_, &status_, WNOHANG) == child_) waited_ = true;
    return waited_;
  }
  Said wait() {
    if (!waited_) ::waitpid(child_, &status_, 0);
    waited_ = true;
    Said said{WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_), text_of(out_), text_of(err_)};
    std::filesystem::remove(out_);
    std::filesystem::remove(err_);
    return said;
  }

 private:
  std::string out_, err_;
  pid_t child_ = 0;
  int status_ = 0;
  bool waited_ = false;
};

inline Said run(const Folder& folder, const std::vector<std::string>& words) { return Running(folder, words).wait(); }

/// `text` with its first `from` replaced; the tests below alter a good file in one place.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

inline const std::string& good_bed() {
  static const std::string text = R"({
  "schema": "apc-bed/1", "name": "test bed", "source": "made for a test",
  "setback": "50 ft", "width": "150 ft", "material": "foam_50psi", "flush": "top",
  "profile": { "distance": {"unit": "ft", "values": [0, 50, 500]}, "depth": {"unit": "in", "values": [0, 18, 18]} },
  "grade": 0.0
})";
  return text;
}

}  // namespace apc::scenarios
