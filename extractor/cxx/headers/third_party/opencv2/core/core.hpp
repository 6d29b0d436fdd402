// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>
#include <cmath>
#include <iosfwd>
#include <algorithm>
#include <bits/c_types.h>
#include <rosarch/any.h>
#define CV_VERSION_MAJOR 3
#define CV_MAJOR_VERSION 3
#define CV_MINOR_VERSION 4
#define CV_VERSION_MINOR 4
#define CV_VERSION "3.4"
#define CV_PI 3.1415926535897932384626433832795
#define CV_MAKETYPE(depth, cn) ((depth) + (((cn) - 1) << 3))
#define CV_MAKE_TYPE CV_MAKETYPE
#define CV_RGB(r, g, b) cv::Scalar((b), (g), (r), 0)
#define CV_Assert(...) ((void)(__VA_ARGS__))
#define CV_DbgAssert(...) ((void)(__VA_ARGS__))
#define CV_EXPORTS
#define CV_EXPORTS_W
#define CV_Error(code, message) ((void)(code), (void)(message))
#define CV_MAT_DEPTH(type) ((type) & 7)
#define CV_MAT_CN(type) (((type) >> 3) + 1)
#define CV_IS_IMAGE(image) ((image) != 0)
#define CV_IMAGE_ELEM(image, type, row, col) (((type*)((image)->imageData + (image)->widthStep * (row)))[(col)])
#define CV_MAT_ELEM(mat, type, row, col) (((type*)((mat).data.ptr + (mat).step * (row)))[(col)])
#define CV_WHOLE_SEQ cvSlice(0, 0x3fffffff)
typedef unsigned char uchar;
typedef signed char schar;
typedef int64_t int64;
typedef uint64_t uint64;
enum rosarch_constants_1 { CV_8U, CV_8S, CV_16U, CV_16S, CV_32S, CV_32F, CV_64F, CV_8UC1 = 0, CV_8UC2 = 8, CV_8UC3 = 16, CV_8UC4 = 24,
  CV_8SC1 = 1, CV_8SC3 = 17, CV_16UC1 = 2, CV_16UC3 = 18, CV_16SC1 = 3, CV_16SC3 = 19, CV_32SC1 = 4, CV_32SC2 = 12, CV_32SC3 = 20,
  CV_32SC4 = 28, CV_32FC1 = 5, CV_32FC2 = 13, CV_32FC3 = 21, CV_32FC4 = 29, CV_64FC1 = 6, CV_64FC2 = 14, CV_64FC3 = 22, CV_64FC4 = 30 };
struct CvSize;
struct CvMat;
struct _IplImage;
namespace cv {
typedef std::string String; typedef unsigned char uchar; using ::ushort; using ::schar;
using std::vector; using std::min; using std::max; using std::swap;
template <class T> struct DataType { enum { type = 0, depth = 0, channels = 1 }; };
template <class T, int m, int n> class Matx {
public:
  T val[m * n]; enum { rows = m, cols = n, channels = m * n }; typedef T value_type; Matx();
    template <class... A, class = typename std::enable_if<(std::is_arithmetic<A>::value && ...)>::type> Matx(T, A...);
    explicit Matx(const T*); T& operator()(int, int); const T& operator()(int, int) const; T& operator()(int);
    const T& operator()(int) const; static Matx eye(); static Matx zeros(); static Matx ones(); static Matx all(T); Matx<T, n, m> t() const;
    Matx<T, n, m> inv(int = 0) const; T dot(const Matx&) const; template <class U> operator Matx<U, m, n>() const;
    Matx mul(const Matx&) const; Matx<T, m, 1> col(int) const; Matx<T, 1, n> row(int) const;
};
template <class T, int m, int k, int n> Matx<T, m, n> operator*(const Matx<T, m, k>&, const Matx<T, k, n>&);
  template <class T, int m, int n> Matx<T, m, n> operator+(const Matx<T, m, n>&, const Matx<T, m, n>&);
  template <class T, int m, int n> Matx<T, m, n> operator-(const Matx<T, m, n>&, const Matx<T, m, n>&);
  template <class T, int m, int n> Matx<T, m, n> operator*(const Matx<T, m, n>&, double);
  template <class T, int m, int n> Matx<T, m, n> operator*(double, const Matx<T, m, n>&);
  template <class T, int m, int n> bool operator==(const Matx<T, m, n>&, const Matx<T, m, n>&);
template <class T, int n> class Vec : public Matx<T, n, 1> { public: Vec(); template <class A, class... R> Vec(const A&, const R&...);
  T& operator[](int); const T& operator[](int) const; Vec cross(const Vec&) const; static Vec all(T); Vec& operator+=(const Vec&);
  Vec& operator-=(const Vec&); Vec operator+(const Vec&) const; Vec operator-(const Vec&) const; Vec operator*(double) const;
  Vec operator/(double) const; Vec& operator*=(double); Vec& operator/=(double); bool operator!=(const Vec&) const; };
typedef Vec<uchar, 2> Vec2b; typedef Vec<uchar, 3> Vec3b; typedef Vec<uchar, 4> Vec4b; typedef Vec<short, 3> Vec3s;
  typedef Vec<ushort, 3> Vec3w; typedef Vec<int, 2> Vec2i; typedef Vec<int, 3> Vec3i; typedef Vec<int, 4> Vec4i;
  typedef Vec<float, 2> Vec2f; typedef Vec<float, 3> Vec3f; typedef Vec<float, 4> Vec4f; typedef Vec<float, 6> Vec6f;
  typedef Vec<double, 2> Vec2d; typedef Vec<double, 3> Vec3d; typedef Vec<double, 4> Vec4d; typedef Matx<float, 3, 3> Matx33f;
  typedef Matx<double, 3, 3> Matx33d; typedef Matx<double, 3, 4> Matx34d; typedef Matx<float, 3, 4> Matx34f;
  typedef Matx<double, 4, 4> Matx44d; typedef Matx<float, 4, 4> Matx44f; typedef Matx<double, 3, 1> Matx31d;
  typedef Matx<double, 2, 3> Matx23d;
template <class T> class Size_ { public: T width, height; typedef T value_type; Size_();
  template <class A, class B> Size_(const A&, const B&); template <class U> Size_(const Size_<U>&); Size_(const ::CvSize&); T area() const;
  bool empty() const; bool operator==(const Size_&) const; bool operator!=(const Size_&) const; Size_ operator*(double) const;
  Size_ operator/(double) const; operator ::CvSize() const; };
}
struct CvSize { int width, height; }; struct CvPoint { int x, y; }; struct CvPoint2D32f { float x, y; };
  struct CvPoint3D32f { float x, y, z; }; struct CvRect { int x, y, width, height; }; struct CvScalar { double val[4]; };
  struct CvTermCriteria { int type, max_iter; double epsilon; }; struct CvSlice { int start_index, end_index; };
namespace cv {
typedef Size_<int> Size; typedef Size Size2i; typedef Size_<float> Size2f; typedef Size_<double> Size2d;
template <class T> class Point_ { public: T x, y; typedef T value_type; Point_(); template <class A, class B> Point_(const A&, const B&);
  template <class U> Point_(const Point_<U>&); Point_(const CvPoint&); Point_(const CvPoint2D32f&);
  template <class U> explicit Point_(const Size_<U>&); template <class U> Point_(const Vec<U, 2>&); operator CvPoint() const;
  T dot(const Point_&) const; double cross(const Point_&) const; template <class R> bool inside(const R&) const;
  Point_& operator+=(const Point_&); Point_& operator-=(const Point_&); Point_& operator*=(double); Point_& operator/=(double); };
template <class T> class Point3_ { public: T x, y, z; typedef T value_type; Point3_();
  template <class A, class B, class C> Point3_(const A&, const B&, const C&); template <class U> Point3_(const Point3_<U>&);
  template <class U> Point3_(const Vec<U, 3>&); T dot(const Point3_&) const; Point3_ cross(const Point3_&) const;
  Point3_& operator+=(const Point3_&); Point3_& operator-=(const Point3_&); Point3_& operator*=(double); Point3_& operator/=(double); };
#define ROSARCH_POINT(P) template <class T, class U> P<T> operator+(const P<T>&, const P<U>&); \
  template <class T, class U> P<T> operator-(const P<T>&, const P<U>&); template <class T> P<T> operator-(const P<T>&); \
  template <class T> P<T> operator*(const P<T>&, double); template <class T> P<T> operator*(double, const P<T>&); \
  template <class T> P<T> operator/(const P<T>&, double); template <class T, class U> bool operator==(const P<T>&, const P<U>&); \
  template <class T, class U> bool operator!=(const P<T>&, const P<U>&); template <class T> double norm(const P<T>&);
ROSARCH_POINT(Point_) ROSARCH_POINT(Point3_)
#undef ROSARCH_POINT
typedef Point_<int> Point; typedef Point Point2i; typedef Point_<float> Point2f; typedef Point_<double> Point2d;
  typedef Point3_<int> Point3i; typedef Point3_<float> Point3f; typedef Point3_<double> Point3d;
template <class T> class Rect_ { public: T x, y, width, height; Rect_();
  template <class A, class B, class C, class D> Rect_(const A&, const B&, const C&, const D&);
  template <class A, class B> Rect_(const A&, const B&); template <class U> Rect_(const Rect_<U>&); Rect_(const CvRect&);
  operator CvRect() const; Point_<T> tl() const; Point_<T> br() const; Size_<T> size() const; T area() const; bool empty() const;
  template <class P> bool contains(const P&) const; Rect_ operator&(const Rect_&) const; Rect_ operator|(const Rect_&) const;
  Rect_& operator&=(const Rect_&); Rect_ operator+(const Point_<T>&) const; Rect_ operator-(const Point_<T>&) const;
  Rect_& operator+=(const Point_<T>&); bool operator==(const Rect_&) const; bool operator!=(const Rect_&) const; };
typedef Rect_<int> Rect; typedef Rect Rect2i; typedef Rect_<float> Rect2f; typedef Rect_<double> Rect2d;
  class RotatedRect { public: Point2f center; Size2f size; float angle; RotatedRect(); RotatedRect(const Point2f&, const Size2f&, float);
  void points(Point2f*) const; Rect boundingRect() const; };
template <class T> class Scalar_ : public Vec<T, 4> { public: Scalar_(); template <class A> Scalar_(const A&);
  template <class A, class B, class... C> Scalar_(const A&, const B&, const C&...); static Scalar_ all(T); operator CvScalar() const; };
  typedef Scalar_<double> Scalar;
class Range { public: int start, end; Range(); Range(int, int); static Range all(); int size() const; };
class TermCriteria { public: enum { COUNT = 1, MAX_ITER = 1, EPS = 2 }; int type, maxCount; double epsilon; TermCriteria();
  TermCriteria(int, int, double); };
class MatExpr; template <class T> class Mat_; template <class M> class MatIterator_;
template <class T> class MatCommaInitializer_ { public: template <class V> MatCommaInitializer_& operator,(const V&);
  operator Mat_<T>() const; };
struct MatStep { operator std::size_t() const; std::size_t& operator[](int); std::size_t p[2]; }; struct MatSize { Size operator()() const;
  int& operator[](int) const; operator const int*() const; int* p; bool operator==(const MatSize&) const;
  bool operator!=(const MatSize&) const; };
class Mat {
public:
  int flags, dims, rows, cols; uchar* data; uchar* dataend; uchar* datastart; MatSize size; MatStep step; enum { AUTO_STEP = 0 };
  Mat(); Mat(const Mat&); Mat(const MatExpr&); template <class A, class... R> Mat(const A&, const R&...); Mat& operator=(const Mat&);
    Mat& operator=(const Scalar&); Mat& operator=(const MatExpr&); template <class T> Mat& operator=(const MatCommaInitializer_<T>&);
    ~Mat();
  Mat row(int) const; Mat col(int) const; Mat rowRange(int, int) const; Mat colRange(int, int) const; Mat rowRange(const Range&) const;
    Mat colRange(const Range&) const; Mat diag(int = 0) const; Mat clone() const; template <class O> void copyTo(O&&) const;
    template <class O, class M> void copyTo(O&&, const M&) const; template <class O> void convertTo(O&&, int, double = 1, double = 0) const;
    template <class V, class... M> Mat& setTo(const V&, const M&...); Mat reshape(int, int = 0) const; Mat t() const;
    Mat inv(int = 0) const; template <class B> Mat mul(const B&, double = 1) const; template <class B> Mat cross(const B&) const;
    template <class B> double dot(const B&) const;
  static Mat zeros(int, int, int); static Mat zeros(Size, int); static Mat ones(int, int, int); static Mat ones(Size, int);
    static Mat eye(int, int, int); static Mat eye(Size, int); template <class... A> void create(const A&...); void release(); void addref();
    template <class V> void push_back(const V&); void pop_back(std::size_t = 1); void resize(std::size_t); void reserve(std::size_t);
    void locateROI(Size&, Point&) const; Mat& adjustROI(int, int, int, int);
  template <class... A> Mat operator()(const A&...) const; bool isContinuous() const; bool isSubmatrix() const;
    std::size_t elemSize() const; std::size_t elemSize1() const; int type() const; int depth() const; int channels() const;
    std::size_t step1(int = 0) const; bool empty() const; std::size_t total() const;
  uchar* ptr(int = 0, int = 0) const; template <class T> T* ptr(int = 0, int = 0) const;
    template <class T, class... I> T& at(const I&...) const; template <class T> T* begin() const; template <class T> T* end() const;
    template <class T> operator Mat_<T>() const; template <class T> operator std::vector<T>() const;
    template <class T, int m, int n> operator Matx<T, m, n>() const; operator ::_IplImage() const; operator ::CvMat() const;
    template <class T, class F> void forEach(const F&); Mat& operator+=(const Mat&); Mat& operator-=(const Mat&); Mat& operator*=(double);
    Mat& operator/=(double); Mat& operator|=(const Mat&); Mat& operator&=(const Mat&);
};
class MatExpr : public Mat { public: using Mat::Mat; MatExpr(const Mat&); };
template <class T> class Mat_ : public Mat { public: Mat_(); template <class... A> explicit Mat_(const A&...); Mat_(const Mat&);
  T& operator()(int, int) const; T& operator()(int) const; T* operator[](int) const; using Mat::operator(); Mat_& operator=(const Mat&);
  T* begin() const; T* end() const; static Mat_ zeros(int, int); static Mat_ zeros(Size); static Mat_ eye(int, int);
  static Mat_ ones(int, int); template <class V> MatCommaInitializer_<T> operator<<(const V&); Mat_ clone() const; };
typedef Mat_<uchar> Mat1b; typedef Mat_<Vec3b> Mat3b; typedef Mat_<float> Mat1f; typedef Mat_<double> Mat1d; typedef Mat_<int> Mat1i;
  typedef Mat UMat; typedef Mat SparseMat; typedef Mat MatND; typedef Mat InputArray; typedef Mat OutputArray; typedef Mat InputOutputArray;
  Mat noArray(); template <class T> using MatIterator = T*; template <class T> using MatConstIterator_ = const T*;
#define ROSARCH_OPERATOR(op) MatExpr operator op(const Mat&, const Mat&); MatExpr operator op(const Mat&, double); \
  MatExpr operator op(double, const Mat&); MatExpr operator op(const Mat&, const Scalar&);
ROSARCH_OPERATOR(+) ROSARCH_OPERATOR(-) ROSARCH_OPERATOR(*) ROSARCH_OPERATOR(/) ROSARCH_OPERATOR(&) ROSARCH_OPERATOR(|)
  ROSARCH_OPERATOR(==) ROSARCH_OPERATOR(!=) ROSARCH_OPERATOR(<) ROSARCH_OPERATOR(>) ROSARCH_OPERATOR(<=) ROSARCH_OPERATOR(>=)
#undef ROSARCH_OPERATOR
MatExpr operator-(const Mat&); MatExpr operator~(const Mat&); MatExpr abs(const Mat&);
template <class T> class Ptr { public: typedef T element_type; Ptr(); Ptr(T*); template <class U> Ptr(const Ptr<U>&); Ptr(std::nullptr_t);
  T* operator->() const; T& operator*() const; T* get() const; operator T*() const; bool empty() const; void release();
  void reset(T* = nullptr); template <class U> Ptr<U> dynamicCast() const; }; template <class T, class... A> Ptr<T> makePtr(const A&...);
template <class T, std::size_t n = 1024> class AutoBuffer { public: AutoBuffer(); explicit AutoBuffer(std::size_t); operator T*();
  void allocate(std::size_t); };
class Exception : public std::exception { public: int code; String err, func, file, msg; int line;
  const char* what() const noexcept override; };
class KeyPoint { public: Point2f pt; float size, angle, response; int octave, class_id; KeyPoint();
  template <class... A> KeyPoint(const A&...); static void convert(const std::vector<KeyPoint>&, std::vector<Point2f>&); };
  class DMatch { public: int queryIdx, trainIdx, imgIdx; float distance; DMatch(); template <class... A> DMatch(const A&...);
  bool operator<(const DMatch&) const; };
class RNG { public: RNG(uint64 = 0); template <class T> T uniform(T, T); double gaussian(double); unsigned next();
  template <class... A> void fill(A&&...); operator int(); operator double(); }; RNG& theRNG(); class TickMeter { public: void start();
  void stop(); void reset(); double getTimeSec() const; double getTimeMilli() const; };
class FileNode { public: FileNode operator[](const char*) const; FileNode operator[](const std::string&) const;
  FileNode operator[](int) const; bool empty() const; bool isNone() const; bool isSeq() const; bool isMap() const; bool isInt() const;
  bool isString() const; std::size_t size() const; std::string name() const; operator int() const; operator float() const;
  operator double() const; operator std::string() const; FileNode* begin() const; FileNode* end() const;
  enum { NONE, INT, REAL, STR, SEQ, MAP }; int type() const; FileNode operator*() const; };
  template <class T> void operator>>(const FileNode&, T&); typedef FileNode* FileNodeIterator;
class FileStorage { public: enum Mode { READ, WRITE, APPEND, MEMORY = 4, FORMAT_XML = 8, FORMAT_YAML = 16 }; FileStorage();
  template <class... A> FileStorage(const A&...); template <class... A> bool open(const A&...); bool isOpened() const; void release();
  FileNode operator[](const char*) const; FileNode operator[](const std::string&) const; FileNode root(int = 0) const;
  FileNode getFirstTopLevelNode() const; template <class V> FileStorage& operator<<(const V&); };
class Algorithm { public: virtual ~Algorithm(); template <class V> void set(const std::string&, const V&);
  static Ptr<Algorithm> create(const std::string&); };
class PCA { public: template <class... A> PCA(const A&...); template <class... A> Mat project(A&&...) const;
  Mat eigenvectors, eigenvalues, mean; Mat backProject(const Mat&) const; template <class... A> PCA& operator()(const A&...); };
  class SVD { public: enum { MODIFY_A = 1, NO_UV = 2, FULL_UV = 4 }; template <class... A> SVD(const A&...); Mat u, w, vt;
  template <class... A> static void compute(A&&...); template <class... A> static void solveZ(A&&...); };
// Functions take anything; their names and results are what is kept.
#define ROSARCH_CV(result, name) template <class... A> result name(A&&...);
#define ROSARCH_VOID(name) ROSARCH_CV(void, name)
ROSARCH_CV(Mat, imread) ROSARCH_CV(Mat, imdecode) ROSARCH_CV(bool, imencode) ROSARCH_CV(bool, imwrite) ROSARCH_CV(int,
  waitKey) ROSARCH_CV(double, norm) ROSARCH_CV(double, threshold) ROSARCH_CV(Scalar, mean) ROSARCH_CV(Scalar, sum) ROSARCH_CV(int,
  countNonZero) ROSARCH_CV(double, determinant) ROSARCH_CV(double, invert) ROSARCH_CV(bool, solve) ROSARCH_CV(Scalar, trace) ROSARCH_CV(Mat,
  getRotationMatrix2D) ROSARCH_CV(Mat, getStructuringElement) ROSARCH_CV(Mat, getPerspectiveTransform) ROSARCH_CV(Mat,
  getAffineTransform) ROSARCH_CV(Rect, boundingRect) ROSARCH_CV(RotatedRect, minAreaRect) ROSARCH_CV(RotatedRect,
  fitEllipse) ROSARCH_CV(double, contourArea) ROSARCH_CV(double, arcLength) ROSARCH_CV(bool, solvePnP) ROSARCH_CV(bool,
  solvePnPRansac) ROSARCH_CV(Mat, findHomography) ROSARCH_CV(Mat, findFundamentalMat) ROSARCH_CV(Mat, findEssentialMat) ROSARCH_CV(Mat,
  estimateRigidTransform) ROSARCH_CV(double, calibrateCamera) ROSARCH_CV(double, stereoCalibrate) ROSARCH_CV(bool,
  findChessboardCorners) ROSARCH_CV(Mat, getOptimalNewCameraMatrix) ROSARCH_CV(double, pointPolygonTest) ROSARCH_CV(double,
  matchShapes) ROSARCH_CV(double, compareHist) ROSARCH_CV(int, createTrackbar) ROSARCH_CV(int, getTrackbarPos) ROSARCH_CV(Size,
  getTextSize) ROSARCH_CV(Mat, repeat) ROSARCH_CV(int, borderInterpolate) ROSARCH_CV(bool, clipLine) ROSARCH_CV(int,
  floodFill) ROSARCH_CV(double, kmeans) ROSARCH_CV(int, connectedComponents) ROSARCH_CV(int, connectedComponentsWithStats) ROSARCH_CV(Mat,
  getGaussianKernel) ROSARCH_CV(int, recoverPose) ROSARCH_CV(float, fastAtan2) ROSARCH_CV(int64, getTickCount) ROSARCH_CV(double,
  getTickFrequency) ROSARCH_CV(int, getOptimalDFTSize) ROSARCH_CV(bool, isContourConvex) ROSARCH_CV(Mat, cvarrToMat) ROSARCH_CV(std::string,
  format) ROSARCH_CV(double, getWindowProperty) ROSARCH_CV(float, intersectConvexConvex) ROSARCH_CV(bool, eigen) ROSARCH_CV(int,
  cvRound_) ROSARCH_CV(bool, checkRange)
ROSARCH_VOID(imshow) ROSARCH_VOID(namedWindow) ROSARCH_VOID(destroyWindow) ROSARCH_VOID(destroyAllWindows) ROSARCH_VOID(moveWindow)
  ROSARCH_VOID(resizeWindow) ROSARCH_VOID(setMouseCallback) ROSARCH_VOID(setTrackbarPos) ROSARCH_VOID(setWindowProperty)
  ROSARCH_VOID(startWindowThread) ROSARCH_VOID(cvtColor) ROSARCH_VOID(resize) ROSARCH_VOID(GaussianBlur) ROSARCH_VOID(blur)
  ROSARCH_VOID(medianBlur) ROSARCH_VOID(bilateralFilter) ROSARCH_VOID(filter2D) ROSARCH_VOID(Sobel) ROSARCH_VOID(Scharr)
  ROSARCH_VOID(Laplacian) ROSARCH_VOID(Canny) ROSARCH_VOID(erode) ROSARCH_VOID(dilate) ROSARCH_VOID(morphologyEx)
  ROSARCH_VOID(adaptiveThreshold) ROSARCH_VOID(equalizeHist) ROSARCH_VOID(calcHist) ROSARCH_VOID(calcBackProject)
  ROSARCH_VOID(findContours) ROSARCH_VOID(drawContours) ROSARCH_VOID(approxPolyDP) ROSARCH_VOID(convexHull) ROSARCH_VOID(convexityDefects)
  ROSARCH_VOID(fitLine) ROSARCH_VOID(minEnclosingCircle) ROSARCH_VOID(HoughLines) ROSARCH_VOID(HoughLinesP) ROSARCH_VOID(HoughCircles)
  ROSARCH_VOID(line) ROSARCH_VOID(rectangle) ROSARCH_VOID(circle) ROSARCH_VOID(ellipse) ROSARCH_VOID(polylines) ROSARCH_VOID(fillPoly)
  ROSARCH_VOID(fillConvexPoly) ROSARCH_VOID(putText) ROSARCH_VOID(arrowedLine) ROSARCH_VOID(drawMarker) ROSARCH_VOID(split)
  ROSARCH_VOID(merge) ROSARCH_VOID(mixChannels) ROSARCH_VOID(extractChannel) ROSARCH_VOID(insertChannel) ROSARCH_VOID(add)
  ROSARCH_VOID(subtract) ROSARCH_VOID(multiply) ROSARCH_VOID(divide) ROSARCH_VOID(addWeighted) ROSARCH_VOID(scaleAdd) ROSARCH_VOID(absdiff)
  ROSARCH_VOID(inRange) ROSARCH_VOID(compare) ROSARCH_VOID(bitwise_and) ROSARCH_VOID(bitwise_or) ROSARCH_VOID(bitwise_not)
  ROSARCH_VOID(bitwise_xor) ROSARCH_VOID(minMaxLoc) ROSARCH_VOID(minMaxIdx) ROSARCH_VOID(meanStdDev) ROSARCH_VOID(normalize)
  ROSARCH_VOID(reduce) ROSARCH_VOID(flip) ROSARCH_VOID(transpose) ROSARCH_VOID(rotate) ROSARCH_VOID(transform)
  ROSARCH_VOID(perspectiveTransform) ROSARCH_VOID(warpAffine) ROSARCH_VOID(warpPerspective) ROSARCH_VOID(remap) ROSARCH_VOID(undistort)
  ROSARCH_VOID(undistortPoints) ROSARCH_VOID(initUndistortRectifyMap) ROSARCH_VOID(projectPoints) ROSARCH_VOID(Rodrigues)
  ROSARCH_VOID(stereoRectify) ROSARCH_VOID(reprojectImageTo3D) ROSARCH_VOID(triangulatePoints) ROSARCH_VOID(cornerSubPix)
  ROSARCH_VOID(goodFeaturesToTrack) ROSARCH_VOID(calcOpticalFlowPyrLK) ROSARCH_VOID(calcOpticalFlowFarneback) ROSARCH_VOID(buildPyramid)
  ROSARCH_VOID(pyrDown) ROSARCH_VOID(pyrUp) ROSARCH_VOID(integral) ROSARCH_VOID(matchTemplate) ROSARCH_VOID(drawKeypoints)
  ROSARCH_VOID(drawMatches) ROSARCH_VOID(FAST) ROSARCH_VOID(drawChessboardCorners) ROSARCH_VOID(copyMakeBorder) ROSARCH_VOID(accumulate)
  ROSARCH_VOID(accumulateWeighted) ROSARCH_VOID(distanceTransform) ROSARCH_VOID(watershed) ROSARCH_VOID(grabCut)
  ROSARCH_VOID(applyColorMap) ROSARCH_VOID(convertScaleAbs) ROSARCH_VOID(LUT) ROSARCH_VOID(hconcat) ROSARCH_VOID(vconcat) ROSARCH_VOID(pow)
  ROSARCH_VOID(sqrt) ROSARCH_VOID(exp) ROSARCH_VOID(log) ROSARCH_VOID(magnitude) ROSARCH_VOID(phase) ROSARCH_VOID(cartToPolar)
  ROSARCH_VOID(polarToCart) ROSARCH_VOID(dft) ROSARCH_VOID(idft) ROSARCH_VOID(gemm) ROSARCH_VOID(randu) ROSARCH_VOID(randn)
  ROSARCH_VOID(setIdentity) ROSARCH_VOID(findNonZero) ROSARCH_VOID(sortIdx) ROSARCH_VOID(setNumThreads) ROSARCH_VOID(groupRectangles)
  ROSARCH_VOID(patchNaNs) ROSARCH_VOID(eigen2cv) ROSARCH_VOID(cv2eigen) ROSARCH_VOID(imagesc) ROSARCH_VOID(decomposeProjectionMatrix)
  ROSARCH_VOID(sepFilter2D) ROSARCH_VOID(boxFilter) ROSARCH_VOID(spatialGradient) ROSARCH_VOID(read) ROSARCH_VOID(write)
  ROSARCH_VOID(cornerHarris) ROSARCH_VOID(calcCovarMatrix) ROSARCH_VOID(mulTransposed) ROSARCH_VOID(completeSymm) ROSARCH_VOID(demosaicing)
#undef ROSARCH_CV
#undef ROSARCH_VOID
template <class T, class V> T saturate_cast(V);
enum rosarch_constants_2 { INTER_NEAREST, INTER_LINEAR, INTER_CUBIC, INTER_AREA, INTER_LANCZOS4, WARP_INVERSE_MAP = 16, BORDER_CONSTANT = 0,
  BORDER_REPLICATE, BORDER_REFLECT, BORDER_WRAP, BORDER_REFLECT_101, BORDER_DEFAULT = 4, MORPH_ERODE = 0, MORPH_DILATE, MORPH_OPEN,
  MORPH_CLOSE, MORPH_GRADIENT, MORPH_TOPHAT, MORPH_BLACKHAT, MORPH_RECT = 0, MORPH_CROSS, MORPH_ELLIPSE, THRESH_BINARY = 0,
  THRESH_BINARY_INV, THRESH_TRUNC, THRESH_TOZERO, THRESH_TOZERO_INV, THRESH_OTSU = 8, ADAPTIVE_THRESH_MEAN_C = 0,
  ADAPTIVE_THRESH_GAUSSIAN_C, RETR_EXTERNAL = 0, RETR_LIST, RETR_CCOMP, RETR_TREE, CHAIN_APPROX_NONE = 1, CHAIN_APPROX_SIMPLE,
  FONT_HERSHEY_SIMPLEX = 0, FONT_HERSHEY_PLAIN, FONT_HERSHEY_DUPLEX, FONT_HERSHEY_COMPLEX, FONT_HERSHEY_TRIPLEX, FONT_HERSHEY_COMPLEX_SMALL,
  FONT_HERSHEY_SCRIPT_SIMPLEX, LINE_4 = 4, LINE_8 = 8, LINE_AA = 16, FILLED = -1, NORM_INF = 1, NORM_L1 = 2, NORM_L2 = 4, NORM_L2SQR = 5,
  NORM_HAMMING = 6, NORM_HAMMING2 = 7, NORM_MINMAX = 32, DECOMP_LU = 0, DECOMP_SVD, DECOMP_EIG, DECOMP_CHOLESKY, DECOMP_QR, CMP_EQ = 0,
  CMP_GT, CMP_GE, CMP_LT, CMP_LE, CMP_NE, REDUCE_SUM = 0, REDUCE_AVG, REDUCE_MAX, REDUCE_MIN, SORT_EVERY_ROW = 0, SORT_ASCENDING = 0,
  SORT_DESCENDING = 16, KMEANS_PP_CENTERS = 2, KMEANS_RANDOM_CENTERS = 0, SOLVEPNP_ITERATIVE = 0, SOLVEPNP_EPNP, SOLVEPNP_P3P, RANSAC = 8,
  LMEDS = 4, FM_RANSAC = 8, FM_8POINT = 2, DIST_L2 = 2, DIST_L1 = 1, HISTCMP_CORREL = 0, TM_CCOEFF_NORMED = 5, TM_SQDIFF = 0,
  TM_CCORR_NORMED = 3,
  IMREAD_UNCHANGED = -1, IMREAD_GRAYSCALE, IMREAD_COLOR, IMREAD_ANYDEPTH, IMREAD_ANYCOLOR = 4, IMWRITE_JPEG_QUALITY = 1,
    IMWRITE_PNG_COMPRESSION = 16, WINDOW_NORMAL = 0, WINDOW_AUTOSIZE = 1, WINDOW_OPENGL = 4096, WINDOW_FREERATIO = 256,
    WINDOW_KEEPRATIO = 0, WND_PROP_FULLSCREEN = 0, WINDOW_FULLSCREEN = 1, EVENT_MOUSEMOVE = 0, EVENT_LBUTTONDOWN, EVENT_RBUTTONDOWN,
    EVENT_MBUTTONDOWN, EVENT_LBUTTONUP, EVENT_RBUTTONUP, EVENT_FLAG_LBUTTON = 1, CAP_PROP_FRAME_WIDTH = 3, CAP_PROP_FRAME_HEIGHT,
    CAP_PROP_FPS, CAP_PROP_FOURCC, CAP_PROP_FRAME_COUNT, CAP_PROP_POS_FRAMES = 1, CAP_PROP_EXPOSURE = 15, CAP_PROP_GAIN = 14,
    CAP_PROP_BUFFERSIZE = 38, CALIB_CB_ADAPTIVE_THRESH = 1, CALIB_CB_NORMALIZE_IMAGE = 2, CALIB_CB_FAST_CHECK = 8,
    CALIB_USE_INTRINSIC_GUESS = 1, CALIB_ZERO_DISPARITY = 1024, OPTFLOW_USE_INITIAL_FLOW = 4, OPTFLOW_FARNEBACK_GAUSSIAN = 256,
    COLORMAP_JET = 2, COLORMAP_HSV = 9, COLORMAP_HOT = 11, CASCADE_SCALE_IMAGE = 2, ROTATE_90_CLOCKWISE = 0, ROTATE_180,
    ROTATE_90_COUNTERCLOCKWISE, HOUGH_GRADIENT = 3,
  COLOR_BGR2GRAY = 6, COLOR_RGB2GRAY, COLOR_GRAY2BGR, COLOR_GRAY2RGB = 8, COLOR_BGR2RGB = 4, COLOR_RGB2BGR = 4, COLOR_BGR2HSV = 40,
    COLOR_RGB2HSV, COLOR_HSV2BGR = 54, COLOR_HSV2RGB, COLOR_BGR2HLS = 52, COLOR_BGR2Lab = 44, COLOR_RGB2Lab, COLOR_Lab2BGR = 56,
    COLOR_BGR2YCrCb = 36, COLOR_YCrCb2BGR = 38, COLOR_BGRA2BGR = 1, COLOR_BGR2BGRA = 0, COLOR_RGBA2BGR = 3, COLOR_BGRA2RGBA = 5,
    COLOR_BGRA2GRAY = 10, COLOR_RGBA2GRAY = 11, COLOR_RGBA2RGB = 1, COLOR_BGR2YUV = 82, COLOR_YUV2BGR = 84, COLOR_YUV2RGB_YUYV = 115,
    COLOR_YUV2BGR_YUY2 = 116, COLOR_YUV2BGR_UYVY = 108, COLOR_BayerBG2BGR = 46, COLOR_BayerGB2BGR, COLOR_BayerRG2BGR, COLOR_BayerGR2BGR,
    COLOR_BayerBG2RGB = 48, COLOR_BayerBG2GRAY = 86, COLOR_BGR2Luv = 50, COLOR_BGR2XYZ = 32 };
class VideoCapture { public: VideoCapture(); template <class... A> VideoCapture(const A&...); template <class... A> bool open(const A&...);
  bool isOpened() const; void release(); bool grab(); bool retrieve(Mat&, int = 0); bool read(Mat&); VideoCapture& operator>>(Mat&);
  bool set(int, double); double get(int) const; };
class VideoWriter { public: VideoWriter(); template <class... A> VideoWriter(const A&...); template <class... A> bool open(const A&...);
  bool isOpened() const; void release(); VideoWriter& operator<<(const Mat&); void write(const Mat&);
  static int fourcc(char, char, char, char); };
class CascadeClassifier { public: CascadeClassifier(); explicit CascadeClassifier(const String&); bool load(const String&);
  bool empty() const; template <class... A> void detectMultiScale(A&&...); };
class HOGDescriptor { public: template <class... A> HOGDescriptor(const A&...); template <class V> void setSVMDetector(const V&);
  template <class... A> void detectMultiScale(A&&...) const; template <class... A> void compute(A&&...) const;
  static std::vector<float> getDefaultPeopleDetector(); Size winSize; };
class KalmanFilter { public: Mat statePre, statePost, transitionMatrix, controlMatrix, measurementMatrix, processNoiseCov,
  measurementNoiseCov, errorCovPre, errorCovPost, gain; KalmanFilter(); KalmanFilter(int, int, int = 0, int = 5);
  void init(int, int, int = 0, int = 5); const Mat& predict(const Mat& = Mat()); const Mat& correct(const Mat&); };
#define ROSARCH_FEATURE(Name) class Name : public Algorithm { public: template <class... A> Name(const A&...); \
  template <class... A> static Ptr<Name> create(const A&...); template <class... A> void detect(A&&...) const; \
  template <class... A> void compute(A&&...) const; template <class... A> void detectAndCompute(A&&...) const; \
  template <class... A> void match(A&&...) const; template <class... A> void knnMatch(A&&...) const; \
  template <class... A> void radiusMatch(A&&...) const; template <class... A> void apply(A&&...); \
  template <class... A> void operator()(A&&...) const; template <class... A> void train(A&&...); template <class... A> void add(A&&...); \
  bool empty() const; };
ROSARCH_FEATURE(Feature2D) ROSARCH_FEATURE(FeatureDetector) ROSARCH_FEATURE(DescriptorExtractor) ROSARCH_FEATURE(DescriptorMatcher)
  ROSARCH_FEATURE(ORB) ROSARCH_FEATURE(SIFT) ROSARCH_FEATURE(SURF) ROSARCH_FEATURE(BRISK) ROSARCH_FEATURE(AKAZE)
  ROSARCH_FEATURE(FastFeatureDetector) ROSARCH_FEATURE(GoodFeaturesToTrackDetector) ROSARCH_FEATURE(BFMatcher)
  ROSARCH_FEATURE(FlannBasedMatcher) ROSARCH_FEATURE(CLAHE) ROSARCH_FEATURE(StereoBM) ROSARCH_FEATURE(StereoSGBM)
  ROSARCH_FEATURE(BackgroundSubtractor) ROSARCH_FEATURE(BackgroundSubtractorMOG2) ROSARCH_FEATURE(Tracker)
  ROSARCH_FEATURE(SimpleBlobDetector) ROSARCH_FEATURE(MSER) ROSARCH_FEATURE(LatentSvmDetector)
#undef ROSARCH_FEATURE
typedef FeatureDetector OrbFeatureDetector; template <class T> class Complex { public: T re, im; };
  template <class... A> Ptr<CLAHE> createCLAHE(const A&...);
  template <class... A> Ptr<BackgroundSubtractorMOG2> createBackgroundSubtractorMOG2(const A&...);
class LineIterator { public: template <class... A> LineIterator(const A&...); int count; uchar* operator*(); LineIterator& operator++();
  LineIterator operator++(int); Point pos() const; }; class ParallelLoopBody { public: virtual ~ParallelLoopBody();
  virtual void operator()(const Range&) const = 0; }; template <class F> void parallel_for_(const Range&, const F&, double = -1);
  class Subdiv2D { public: template <class... A> Subdiv2D(const A&...); template <class... A> void insert(const A&...);
  template <class... A> void getTriangleList(A&&...) const; };
  class CommandLineParser { public: CommandLineParser(int, const char* const*, const String&);
  template <class T> T get(const String&, bool = true) const; bool has(const String&) const; bool check() const; void printMessage() const;
  void printErrors() const; void about(const String&); };
namespace flann { struct IndexParams {}; struct KDTreeIndexParams : IndexParams { KDTreeIndexParams(int = 4); };
  struct LshIndexParams : IndexParams { LshIndexParams(int, int, int); }; struct SearchParams { SearchParams(int = 32); };
  class Index { public: template <class... A> Index(const A&...); template <class... A> void knnSearch(A&&...);
  template <class... A> int radiusSearch(A&&...); }; }
namespace fisheye { template <class... A> void undistortPoints(A&&...); template <class... A> void initUndistortRectifyMap(A&&...);
  template <class... A> void undistortImage(A&&...); template <class... A> void projectPoints(A&&...);
  template <class... A> void estimateNewCameraMatrixForUndistortRectify(A&&...); }
namespace cuda { typedef Mat GpuMat; class Stream {}; int getCudaEnabledDeviceCount(); void setDevice(int); }
  namespace gpu { using namespace cuda; using cuda::GpuMat; } namespace ocl {} namespace ml {} namespace xfeatures2d { using cv::SIFT;
  using cv::SURF; } namespace dnn { class Net { public: void setInput(const Mat&, const String& = ""); Mat forward(const String& = "");
  bool empty() const; }; template <class... A> Net readNetFromCaffe(const A&...); template <class... A> Net readNetFromDarknet(const A&...);
  template <class... A> Mat blobFromImage(const A&...); } namespace videostab {} namespace detail {} namespace aruco {}
}
// The C interface.
typedef void CvArr; typedef struct _IplImage { int nSize, nChannels, depth, origin, width, height, imageSize, widthStep; char* imageData;
  char* imageDataOrigin; void* roi; } IplImage;
struct CvMat { int type, step, rows, cols, width, height; union { uchar* ptr; short* s; int* i; float* fl; double* db; } data; };
  struct CvMemStorage; struct CvSeq { int total; CvSeq *h_next, *h_prev, *v_next, *v_prev; int flags, elem_size; }; typedef CvSeq CvContour;
  struct CvCapture; struct CvVideoWriter; struct CvFont { template <class... A> CvFont(const A&...); CvFont(); }; struct CvHistogram;
  struct CvMoments; struct CvBox2D { CvPoint2D32f center; struct { float width, height; } size; float angle; }; struct CvFileStorage;
  struct CvAttrList {}; typedef struct CvKalman CvKalman; struct CvRNG {}; struct CvSURFPoint { CvPoint2D32f pt; int laplacian, size;
  float dir, hessian; }; struct CvSize2D32f { float width, height; };
CvPoint cvPoint(int, int = 0); CvSize cvSize(int, int); CvRect cvRect(int, int, int, int);
  CvScalar cvScalar(double, double = 0, double = 0, double = 0); CvScalar cvScalarAll(double); CvPoint2D32f cvPoint2D32f(double, double);
  CvTermCriteria cvTermCriteria(int, int, double); CvSlice cvSlice(int, int); int cvRound(double); int cvFloor(double); int cvCeil(double);
  bool cvIsNaN(double); bool cvIsInf(double); CvPoint cvPointFrom32f(CvPoint2D32f); CvScalar cvRealScalar(double);
#define ROSARCH_CV(result, name) template <class... A> result name(A&&...);
ROSARCH_CV(IplImage*, cvCreateImage) ROSARCH_CV(IplImage*, cvCloneImage) ROSARCH_CV(IplImage*, cvLoadImage) ROSARCH_CV(IplImage*,
  cvQueryFrame) ROSARCH_CV(IplImage*, cvCreateImageHeader) ROSARCH_CV(CvMat*, cvCreateMat) ROSARCH_CV(CvMat*, cvCloneMat) ROSARCH_CV(CvMat*,
  cvLoadImageM) ROSARCH_CV(CvMat, cvMat) ROSARCH_CV(void, cvReleaseImage) ROSARCH_CV(void, cvReleaseMat) ROSARCH_CV(void,
  cvReleaseMemStorage) ROSARCH_CV(CvMemStorage*, cvCreateMemStorage) ROSARCH_CV(void, cvShowImage) ROSARCH_CV(int,
  cvNamedWindow) ROSARCH_CV(void, cvDestroyWindow) ROSARCH_CV(void, cvDestroyAllWindows) ROSARCH_CV(int, cvWaitKey) ROSARCH_CV(void,
  cvCvtColor) ROSARCH_CV(void, cvResize) ROSARCH_CV(void, cvLine) ROSARCH_CV(void, cvRectangle) ROSARCH_CV(void, cvCircle) ROSARCH_CV(void,
  cvPutText) ROSARCH_CV(void, cvInitFont) ROSARCH_CV(void, cvSetZero) ROSARCH_CV(void, cvZero) ROSARCH_CV(void, cvSet) ROSARCH_CV(void,
  cvSet2D) ROSARCH_CV(CvScalar, cvGet2D) ROSARCH_CV(void, cvCopy) ROSARCH_CV(void, cvThreshold) ROSARCH_CV(void, cvSmooth) ROSARCH_CV(void,
  cvErode) ROSARCH_CV(void, cvDilate) ROSARCH_CV(void, cvCanny) ROSARCH_CV(int, cvSaveImage) ROSARCH_CV(void,
  cvSetImageROI) ROSARCH_CV(void, cvResetImageROI) ROSARCH_CV(CvSize, cvGetSize) ROSARCH_CV(void, cvMoveWindow) ROSARCH_CV(void,
  cvResizeWindow) ROSARCH_CV(void, cvSetMouseCallback) ROSARCH_CV(int, cvCreateTrackbar) ROSARCH_CV(CvSeq*,
  cvHoughLines2) ROSARCH_CV(schar*, cvGetSeqElem) ROSARCH_CV(void, cvSetReal2D) ROSARCH_CV(double, cvGetReal2D) ROSARCH_CV(void,
  cvmSet) ROSARCH_CV(double, cvmGet) ROSARCH_CV(void, cvSplit) ROSARCH_CV(void, cvMerge) ROSARCH_CV(void, cvFlip) ROSARCH_CV(int,
  cvFindContours) ROSARCH_CV(void, cvWarpPerspective) ROSARCH_CV(void, cvSetWindowProperty) ROSARCH_CV(void, cvGetTextSize) ROSARCH_CV(void,
  cvStartWindowThread) ROSARCH_CV(CvCapture*, cvCreateCameraCapture) ROSARCH_CV(CvCapture*, cvCreateFileCapture) ROSARCH_CV(void,
  cvReleaseCapture) ROSARCH_CV(void*, cvGetWindowHandle) ROSARCH_CV(const char*, cvGetWindowName) ROSARCH_CV(int64,
  cvGetTickCount) ROSARCH_CV(double, cvGetTickFrequency) ROSARCH_CV(void*, cvGetWindowProperty) ROSARCH_CV(void, cvEllipse) ROSARCH_CV(void,
  cvFillPoly) ROSARCH_CV(void, cvReleaseHaarClassifierCascade) ROSARCH_CV(void*, cvLoad) ROSARCH_CV(void,
  cvClearMemStorage) ROSARCH_CV(void, cvUndistort2) ROSARCH_CV(void, cvRemap) ROSARCH_CV(void, cvGetRectSubPix) ROSARCH_CV(void,
  cvSetData) ROSARCH_CV(double, cvNorm) ROSARCH_CV(double, cvDotProduct) ROSARCH_CV(void, cvMatMul) ROSARCH_CV(void,
  cvTranspose) ROSARCH_CV(double, cvInvert) ROSARCH_CV(void, cvInitMatHeader)
#undef ROSARCH_CV
enum rosarch_constants_3 { CV_BGR2GRAY = 6, CV_RGB2GRAY, CV_GRAY2BGR, CV_GRAY2RGB = 8, CV_BGR2RGB = 4, CV_RGB2BGR = 4, CV_BGR2HSV = 40,
  CV_RGB2HSV, CV_HSV2BGR = 54, CV_HSV2RGB, CV_BGR2HLS = 52, CV_BGR2Lab = 44, CV_RGB2Lab, CV_BGRA2BGR = 1, CV_BGR2YCrCb = 36,
  CV_BGR2YUV = 82, CV_BayerBG2BGR = 46, CV_BayerGB2BGR, CV_BayerRG2BGR, CV_BayerGR2BGR, CV_BayerRG2RGB = 46, CV_BGR2BGRA = 0,
  CV_BGRA2RGBA = 5, CV_RGBA2BGR = 3, CV_BGR2BGR555 = 22, CV_INTER_NN = 0, CV_INTER_LINEAR, CV_INTER_CUBIC, CV_INTER_AREA,
  CV_WARP_INVERSE_MAP = 16, CV_WARP_FILL_OUTLIERS = 8, CV_THRESH_BINARY = 0, CV_THRESH_BINARY_INV, CV_THRESH_TRUNC, CV_THRESH_TOZERO,
  CV_THRESH_OTSU = 8, CV_RETR_EXTERNAL = 0, CV_RETR_LIST, CV_RETR_CCOMP, CV_RETR_TREE, CV_CHAIN_APPROX_NONE = 1, CV_CHAIN_APPROX_SIMPLE,
  CV_FONT_HERSHEY_SIMPLEX = 0, CV_FONT_HERSHEY_PLAIN, CV_FONT_HERSHEY_DUPLEX, CV_FONT_HERSHEY_COMPLEX, CV_FONT_HERSHEY_TRIPLEX, CV_AA = 16,
  CV_FILLED = -1, CV_LOAD_IMAGE_COLOR = 1, CV_LOAD_IMAGE_GRAYSCALE = 0, CV_LOAD_IMAGE_UNCHANGED = -1, CV_WINDOW_AUTOSIZE = 1,
  CV_WINDOW_NORMAL = 0, CV_WINDOW_KEEPRATIO = 0, CV_WINDOW_FREERATIO = 256, CV_WINDOW_OPENGL = 4096, CV_GUI_NORMAL = 16,
  CV_GUI_EXPANDED = 0, CV_WND_PROP_FULLSCREEN = 0, CV_WINDOW_FULLSCREEN = 1, CV_TERMCRIT_ITER = 1, CV_TERMCRIT_EPS = 2,
  CV_TERMCRIT_NUMBER = 1, CV_GAUSSIAN = 2, CV_MEDIAN = 3, CV_BLUR = 1, CV_MINMAX = 32, CV_L2 = 4, CV_L1 = 2, CV_C = 1, CV_SVD = 1,
  CV_LU = 0, CV_COVAR_NORMAL = 1, CV_HOUGH_GRADIENT = 3, CV_HOUGH_STANDARD = 0, CV_HOUGH_PROBABILISTIC = 1, CV_SHAPE_RECT = 0,
  CV_SHAPE_CROSS = 1, CV_SHAPE_ELLIPSE = 2, CV_MOP_OPEN = 2, CV_MOP_CLOSE = 3, CV_ADAPTIVE_THRESH_MEAN_C = 0, CV_ADAPTIVE_THRESH_GAUSSIAN_C,
  CV_IMWRITE_JPEG_QUALITY = 1, CV_IMWRITE_PNG_COMPRESSION = 16, CV_EVENT_MOUSEMOVE = 0, CV_EVENT_LBUTTONDOWN, CV_EVENT_RBUTTONDOWN,
  CV_EVENT_MBUTTONDOWN, CV_EVENT_LBUTTONUP, CV_EVENT_RBUTTONUP, CV_EVENT_FLAG_LBUTTON = 1, CV_CAP_PROP_FRAME_WIDTH = 3,
  CV_CAP_PROP_FRAME_HEIGHT, CV_CAP_PROP_FPS, CV_CAP_PROP_FOURCC, CV_CAP_PROP_FRAME_COUNT, CV_CAP_PROP_POS_FRAMES = 1,
  CV_CAP_PROP_EXPOSURE = 15, CV_CAP_PROP_GAIN = 14, CV_HAAR_SCALE_IMAGE = 2, CV_HAAR_FIND_BIGGEST_OBJECT = 4,
  CV_CALIB_CB_ADAPTIVE_THRESH = 1, CV_CALIB_CB_FILTER_QUADS = 4, CV_CALIB_CB_FAST_CHECK = 8, CV_CALIB_CB_NORMALIZE_IMAGE = 2,
  CV_COMP_CORREL = 0, CV_HIST_ARRAY = 0, CV_TM_CCOEFF_NORMED = 5, CV_TM_CCORR_NORMED = 3, CV_TM_SQDIFF = 0, CV_TM_CCORR = 2, CV_DIST_L2 = 2,
  CV_STORAGE_READ = 0, CV_STORAGE_WRITE = 1, CV_FOURCC_PROMPT = -1, CV_RANSAC = 8, CV_ITERATIVE = 0, CV_EPNP = 1, CV_P3P = 2,
  CV_POLY_APPROX_DP = 0, CV_CLOCKWISE = 1, IPL_DEPTH_8U = 8, IPL_DEPTH_16U = 16, IPL_DEPTH_32F = 32, IPL_DEPTH_64F = 64, IPL_ORIGIN_TL = 0,
  IPL_DEPTH_1U = 1, IPL_DEPTH_16S = -16, IPL_DEPTH_8S = -8, IPL_DEPTH_32S = -32, CV_REDUCE_SUM = 0, CV_REDUCE_AVG = 1, CV_REDUCE_MAX = 2,
  CV_REDUCE_MIN = 3, CV_SORT_EVERY_ROW = 0, CV_SORT_ASCENDING = 0, CV_SORT_DESCENDING = 16, CV_PCA_DATA_AS_ROW = 0, CV_BGR5652BGR = 14,
  CV_YUV2RGB_YUYV = 115, CV_YUV2BGR_YUYV = 116, CV_YUV2RGB_UYVY = 107, CV_YUV2BGR_UYVY = 108, CV_BayerGR2RGB = 47, CV_BayerGB2RGB = 49,
  CV_BayerBG2RGB = 48, CV_Lab2BGR = 56, CV_StsOk = 0, CV_StsBadArg = -5, CV_StsError = -2, CV_CVTIMG_FLIP = 1, CV_CAP_ANY = 0, CV_8UC = 0 };
int CV_FOURCC(char, char, char, char);
