#pragma once
// The part of HDF5 that results need. No HDF5 type appears here.

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace shoreline {

/// An open HDF5 file.
///
/// Paths are those inside the file; groups on the way are made. Every function throws OutputError with the file and
/// the library's reason.
class Hdf5File {
 public:
  enum class Mode { create, append, read };

  Hdf5File(const std::filesystem::path& file, Mode mode);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  [[nodiscard]] bool contains(const std::string& path) const;
  void make_group(const std::string& path);

  /// What a group holds, in the order of the alphabet.
  [[nodiscard]] std::vector<std::string> names(const std::string& group) const;

  /// An array of two dimensions; its rows become columns.
  [[nodiscard]] Eigen::MatrixXd rows(const std::string& path) const;

  /// Columns of @p columns become the rows of the file, which has one row a point.
  void write_rows(const std::string& path, const Eigen::Ref<const Eigen::MatrixXd>& columns, const std::string& unit);
  void write_numbers(const std::string& path, const Eigen::VectorXd& numbers, const std::string& unit);
  void write_table(const std::string& path, const Eigen::MatrixXi& columns);

  /// Adds columns of @p columns as rows to an array that grows, which is made where it is missing. Rows of one number
  /// make a vector.
  void append_rows(const std::string& path, const Eigen::MatrixXd& columns, const std::string& unit);

  void set_attribute(const std::string& path, const std::string& name, const std::string& text);
  void set_attribute(const std::string& path, const std::string& name, double number);
  void set_attribute(const std::string& path, const std::string& name, int number);

  /// Brings everything to disk; the destructor closes too, but cannot say that it failed.
  void close();

 private:
  std::filesystem::path file_;
  std::int64_t id_ = -1;
};

/// Makes sure that @p bytes more can be appended to @p file: a disk that fills up while an HDF5 file is written would
/// cost what it held before. The file is cut back to what it holds when it is closed.
/// @throws OutputError with the system's reason; the file is as it was
void reserve(const std::filesystem::path& file, std::uintmax_t bytes);

}  // namespace shoreline
