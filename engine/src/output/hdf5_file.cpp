#include "hdf5_file.hpp"

#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <array>
#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

#include "shoreline/engine/failures.hpp"

namespace shoreline {
namespace {

/// Keeps the library from printing: its reason goes into the exception.
class Quiet {
 public:
  Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// The operating system's reason in the innermost entry of the library's error stack, or the whole of that entry.
std::string reason() {
  std::string text;
  const auto keep_first = [](unsigned, const H5E_error2_t* entry, void* to) -> herr_t {
    auto& kept = *static_cast<std::string*>(to);
    if (kept.empty()) kept = entry->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &text);
  const std::string label = "error message = '";
  if (const std::size_t at = text.find(label); at != std::string::npos) {
    const std::size_t begin = at + label.size();
    return text.substr(begin, text.find('\'', begin) - begin);
  }
  return text.empty() ? "unknown reason" : text;
}

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what, const char* act = "write") {
  throw OutputError(file.string() + ": cannot " + act + (what.empty() ? "" : " " + what) + ": " + reason());
}

/// Owns one identifier of the library.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] bool valid() const { return id_ >= 0; }

 private:
  hid_t id_;
  Close close_;
};

/// Names in UTF-8, groups on the way made.
Handle link_properties() {
  const hid_t id = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_char_encoding(id, H5T_CSET_UTF8);
  H5Pset_create_intermediate_group(id, 1);
  return {id, H5Pclose};
}

bool write_array(hid_t file, const std::string& path, hid_t type, const void* data, const std::vector<hsize_t>& shape) {
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  const Handle links = link_properties();
  const Handle set(H5Dcreate2(file, path.c_str(), type, space.id(), links.id(), H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  return set.valid() && H5Dwrite(set.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0;
}

/// An array without rows yet; of one dimension where a row is one number.
bool make_growing(hid_t file, const std::string& path, hsize_t width) {
  constexpr hsize_t rows_a_page = 256;
  const int rank = width == 1 ? 1 : 2;
  const std::array<hsize_t, 2> none{0, width}, any{H5S_UNLIMITED, width}, page{rows_a_page, width};
  const Handle space(H5Screate_simple(rank, none.data(), any.data()), H5Sclose);
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(creation.id(), rank, page.data());
  const Handle links = link_properties();
  return Handle(H5Dcreate2(file, path.c_str(), H5T_NATIVE_DOUBLE, space.id(), links.id(), creation.id(), H5P_DEFAULT),
                H5Dclose)
      .valid();
}

bool write_last_rows(hid_t file, const std::string& path, const Eigen::MatrixXd& columns) {
  const Handle set(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  std::array<hsize_t, 2> size{};
  {
    const Handle space(H5Dget_space(set.id()), H5Sclose);
    H5Sget_simple_extent_dims(space.id(), size.data(), nullptr);
  }
  const std::array<hsize_t, 2> start{size[0], 0};
  const std::array<hsize_t, 2> count{static_cast<hsize_t>(columns.cols()), static_cast<hsize_t>(columns.rows())};
  size[0] += count[0];
  if (H5Dset_extent(set.id(), size.data()) < 0) return false;
  const Handle space(H5Dget_space(set.id()), H5Sclose);
  H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  const Handle memory(H5Screate_simple(2, count.data(), nullptr), H5Sclose);
  return H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, columns.data()) >= 0;
}

bool write_attribute(hid_t file, const std::string& path, const std::string& name, hid_t type, const void* value) {
  const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), H5Oclose);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.valid() && H5Awrite(attribute.id(), type, value) >= 0;
}

}  // namespace

Hdf5File::Hdf5File(const std::filesystem::path& file, Mode mode) : file_(file) {
  const Quiet quiet;
  id_ = mode == Mode::create ? H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)
                             : H5Fopen(file.c_str(), mode == Mode::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR, H5P_DEFAULT);
  if (id_ < 0) fail(file_, "", mode == Mode::read ? "read" : "write");
}

Hdf5File::~Hdf5File() {
  const Quiet quiet;
  if (id_ >= 0) H5Fclose(id_);
}

bool Hdf5File::contains(const std::string& path) const {
  const Quiet quiet;
  return H5Lexists(id_, path.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5File::make_group(const std::string& path) {
  const Quiet quiet;
  const Handle links = link_properties();
  const Handle group(H5Gcreate2(id_, path.c_str(), links.id(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  if (!group.valid()) fail(file_, path);
}

std::vector<std::string> Hdf5File::names(const std::string& group) const {
  const Quiet quiet;
  std::vector<std::string> found;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
    static_cast<std::vector<std::string>*>(to)->emplace_back(name);
    return 0;
  };
  if (H5Literate_by_name(id_, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &found, H5P_DEFAULT) < 0)
    fail(file_, group, "read");
  return found;
}

Eigen::MatrixXd Hdf5File::rows(const std::string& path) const {
  const Quiet quiet;
  const Handle set(H5Dopen2(id_, path.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle space(H5Dget_space(set.id()), H5Sclose);
  std::array<hsize_t, 2> shape{};
  if (H5Sget_simple_extent_ndims(space.id()) != 2 || H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr) < 0)
    fail(file_, path, "read");
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(shape[1]), static_cast<Eigen::Index>(shape[0]));
  if (H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, columns.data()) < 0)
    fail(file_, path, "read");
  return columns;
}

void Hdf5File::write_rows(const std::string& path, const Eigen::Ref<const Eigen::MatrixXd>& columns,
                          const std::string& unit) {
  assert(columns.outerStride() == columns.rows() || columns.cols() < 2);
  const Quiet quiet;
  const std::vector<hsize_t> shape{static_cast<hsize_t>(columns.cols()), static_cast<hsize_t>(columns.rows())};
  if (!write_array(id_, path, H5T_NATIVE_DOUBLE, columns.data(), shape)) fail(file_, path);
  set_attribute(path, "unit", unit);
}

void Hdf5File::write_numbers(const std::string& path, const Eigen::VectorXd& numbers, const std::string& unit) {
  const Quiet quiet;
  if (!write_array(id_, path, H5T_NATIVE_DOUBLE, numbers.data(), {static_cast<hsize_t>(numbers.size())}))
    fail(file_, path);
  set_attribute(path, "unit", unit);
}

void Hdf5File::write_table(const std::string& path, const Eigen::MatrixXi& columns) {
  const Quiet quiet;
  const std::vector<hsize_t> shape{static_cast<hsize_t>(columns.cols()), static_cast<hsize_t>(columns.rows())};
  if (!write_array(id_, path, H5T_NATIVE_INT, columns.data(), shape)) fail(file_, path);
}

void Hdf5File::append_rows(const std::string& path, const Eigen::MatrixXd& columns, const std::string& unit) {
  const Quiet quiet;
  if (!contains(path)) {
    if (!make_growing(id_, path, static_cast<hsize_t>(columns.rows()))) fail(file_, path);
    set_attribute(path, "unit", unit);
  }
  if (!write_last_rows(id_, path, columns)) fail(file_, path);
}

void Hdf5File::set_attribute(const std::string& path, const std::string& name, const std::string& text) {
  const Quiet quiet;
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), H5T_VARIABLE);  // h5py reads it as a str
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  const char* value = text.c_str();
  if (!write_attribute(id_, path, name, type.id(), &value)) fail(file_, path + " " + name);
}

void Hdf5File::set_attribute(const std::string& path, const std::string& name, double number) {
  const Quiet quiet;
  if (!write_attribute(id_, path, name, H5T_NATIVE_DOUBLE, &number)) fail(file_, path + " " + name);
}

void Hdf5File::set_attribute(const std::string& path, const std::string& name, int number) {
  const Quiet quiet;
  if (!write_attribute(id_, path, name, H5T_NATIVE_INT, &number)) fail(file_, path + " " + name);
}

void Hdf5File::close() {
  const Quiet quiet;
  if (H5Fclose(std::exchange(id_, -1)) < 0) fail(file_, "");
}

void reserve(const std::filesystem::path& file, std::uintmax_t bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY);
  if (descriptor < 0) throw OutputError(file.string() + ": cannot write: " + std::generic_category().message(errno));
  const off_t size = lseek(descriptor, 0, SEEK_END);
  const int problem = posix_fallocate(descriptor, size, static_cast<off_t>(bytes));
  const bool kept = problem == 0 || ftruncate(descriptor, size) == 0;
  ::close(descriptor);
  if (problem != 0)
    throw OutputError(file.string() + ": cannot write " + std::to_string(bytes) + " bytes more: " +
                      std::generic_category().message(problem) + (kept ? "" : "; the file may be damaged"));
}

}  // namespace shoreline
