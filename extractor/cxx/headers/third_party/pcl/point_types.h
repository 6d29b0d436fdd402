// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>
#include <boost/shared_ptr.hpp>
#include <boost/make_shared.hpp>
#include <cstdint>
#include <string>
#include <vector>
#include <ostream>
#define PCL_ADD_POINT4D union { float data[4]; struct { float x, y, z; }; };
#define PCL_ADD_NORMAL4D union { float data_n[4]; float normal[3]; struct { float normal_x, normal_y, normal_z; }; };
#define PCL_ADD_RGB union { struct { uint8_t b, g, r, a; }; float rgb; uint32_t rgba; };
#define PCL_ADD_INTENSITY float intensity;
#define ROSARCH_POINT_MAPS Eigen::Vector3f& getVector3fMap(); const Eigen::Vector3f& getVector3fMap() const; \
  Eigen::Vector4f& getVector4fMap(); const Eigen::Vector4f& getVector4fMap() const; Eigen::Vector3f& getArray3fMap(); \
  Eigen::Vector3f& getNormalVector3fMap(); const Eigen::Vector3f& getNormalVector3fMap() const;
#define POINT_CLOUD_REGISTER_POINT_STRUCT(...)
#define POINT_CLOUD_REGISTER_POINT_WRAPPER(...)
#define PCL_INSTANTIATE(...)
#define PCL_EXPORTS
#define PCL_INLINE inline
#define PCL_ERROR(...) ::pcl::console::print(__VA_ARGS__)
#define PCL_WARN(...) ::pcl::console::print(__VA_ARGS__)
#define PCL_INFO(...) ::pcl::console::print(__VA_ARGS__)
#define PCL_DEBUG(...) ::pcl::console::print(__VA_ARGS__)
#define PCL_VERSION 101000
#define PCL_MAJOR_VERSION 1
#define PCL_MINOR_VERSION 10
#define PCL_VERSION_COMPARE(op, major, minor, patch) (PCL_VERSION op((major)*100000 + (minor)*100 + (patch)))
#define pcl_isfinite(x) std::isfinite(x)
#define pcl_isnan(x) std::isnan(x)
namespace pcl {
namespace console { template <class... A> void print(const A&...);
  enum VERBOSITY_LEVEL { L_ALWAYS, L_ERROR, L_WARN, L_INFO, L_DEBUG, L_VERBOSE }; void setVerbosityLevel(VERBOSITY_LEVEL);
  template <class... A> int parse_argument(const A&...); template <class... A> int parse(const A&...);
  template <class... A> bool find_switch(const A&...); template <class... A> std::vector<int> parse_file_extension_argument(const A&...);
class TicToc { public: void tic(); double toc() const; void toc_print() const; }; template <class... A> void print_info(const A&...);
  template <class... A> void print_error(const A&...); template <class... A> void print_highlight(const A&...);
  template <class... A> void print_value(const A&...); template <class... A> void print_warn(const A&...); }
using std::uint8_t; using std::uint16_t; using std::uint32_t; using std::uint64_t; using std::int32_t;
typedef std::vector<int> Indices; typedef boost::shared_ptr<std::vector<int>> IndicesPtr;
  typedef boost::shared_ptr<const std::vector<int>> IndicesConstPtr; using boost::shared_ptr; using boost::make_shared;
struct PCLHeader { uint32_t seq; uint64_t stamp; std::string frame_id; typedef boost::shared_ptr<PCLHeader> Ptr; };
struct PCLPointField { std::string name; uint32_t offset; uint8_t datatype; uint32_t count;
  enum { INT8 = 1, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 }; };
struct PCLPointCloud2 { PCLHeader header; uint32_t height, width; std::vector<PCLPointField> fields; uint8_t is_bigendian;
  uint32_t point_step, row_step; std::vector<uint8_t> data; uint8_t is_dense; typedef boost::shared_ptr<PCLPointCloud2> Ptr;
  typedef boost::shared_ptr<const PCLPointCloud2> ConstPtr; };
typedef PCLPointCloud2::Ptr PCLPointCloud2Ptr; typedef PCLPointCloud2::ConstPtr PCLPointCloud2ConstPtr;
struct PointXYZ { PCL_ADD_POINT4D ROSARCH_POINT_MAPS PointXYZ(); PointXYZ(float, float, float); };
struct PointXYZI { PCL_ADD_POINT4D float intensity; ROSARCH_POINT_MAPS PointXYZI(); PointXYZI(float);
  PointXYZI(float, float, float, float = 0); };
struct PointXYZL { PCL_ADD_POINT4D uint32_t label; ROSARCH_POINT_MAPS };
struct PointXYZRGB { PCL_ADD_POINT4D PCL_ADD_RGB ROSARCH_POINT_MAPS Eigen::Vector3i getRGBVector3i(); PointXYZRGB();
  PointXYZRGB(uint8_t, uint8_t, uint8_t); PointXYZRGB(float, float, float, uint8_t, uint8_t, uint8_t); };
struct PointXYZRGBA : PointXYZRGB { using PointXYZRGB::PointXYZRGB; }; struct PointXYZRGBL : PointXYZRGB { uint32_t label; };
struct PointXYZHSV { PCL_ADD_POINT4D float h, s, v; }; struct PointXY { float x, y; }; struct PointUV { float u, v; };
  struct RGB { PCL_ADD_RGB }; struct Intensity { float intensity; }; struct Label { uint32_t label; };
struct Normal { PCL_ADD_NORMAL4D float curvature; ROSARCH_POINT_MAPS Normal(); Normal(float, float, float); };
  struct Axis { PCL_ADD_NORMAL4D };
struct PointNormal { PCL_ADD_POINT4D PCL_ADD_NORMAL4D float curvature; ROSARCH_POINT_MAPS };
  struct PointXYZINormal { PCL_ADD_POINT4D PCL_ADD_NORMAL4D float intensity, curvature; ROSARCH_POINT_MAPS };
  struct PointXYZRGBNormal { PCL_ADD_POINT4D PCL_ADD_NORMAL4D PCL_ADD_RGB float curvature; ROSARCH_POINT_MAPS };
struct PointWithRange { PCL_ADD_POINT4D float range; }; struct PointWithViewpoint { PCL_ADD_POINT4D float vp_x, vp_y, vp_z; };
  struct FPFHSignature33 { float histogram[33]; }; struct VFHSignature308 { float histogram[308]; };
  struct PFHSignature125 { float histogram[125]; }; struct SHOT352 { float descriptor[352]; float rf[9]; };
  struct PrincipalCurvatures { float pc1, pc2; }; struct ReferenceFrame { float rf[9]; }; struct Boundary { uint8_t boundary_point; };
  template <int n> struct Histogram { float histogram[n]; };
struct PointIndices { PCLHeader header; std::vector<int> indices; typedef boost::shared_ptr<PointIndices> Ptr;
  typedef boost::shared_ptr<const PointIndices> ConstPtr; }; typedef PointIndices::Ptr PointIndicesPtr;
  typedef PointIndices::ConstPtr PointIndicesConstPtr;
struct ModelCoefficients { PCLHeader header; std::vector<float> values; typedef boost::shared_ptr<ModelCoefficients> Ptr;
  typedef boost::shared_ptr<const ModelCoefficients> ConstPtr; }; typedef ModelCoefficients::Ptr ModelCoefficientsPtr;
struct Vertices { std::vector<uint32_t> vertices; }; struct PolygonMesh { PCLHeader header; PCLPointCloud2 cloud;
  std::vector<Vertices> polygons; typedef boost::shared_ptr<PolygonMesh> Ptr; }; struct Correspondence { int index_query, index_match;
  float distance; }; typedef std::vector<Correspondence> Correspondences; typedef boost::shared_ptr<Correspondences> CorrespondencesPtr;
template <class T> bool isFinite(const T&);
template <class T> class PointCloud {
public:
  PCLHeader header; std::vector<T, Eigen::aligned_allocator<T>> points; uint32_t width, height; bool is_dense;
    Eigen::Vector4f sensor_origin_; Eigen::Quaternionf sensor_orientation_;
  typedef T PointType; typedef T value_type; typedef std::vector<T, Eigen::aligned_allocator<T>> VectorType;
    typedef boost::shared_ptr<PointCloud<T>> Ptr; typedef boost::shared_ptr<const PointCloud<T>> ConstPtr;
    typedef typename VectorType::iterator iterator; typedef typename VectorType::const_iterator const_iterator;
  PointCloud(); PointCloud(const PointCloud&); PointCloud(const PointCloud&, const std::vector<int>&);
    PointCloud(uint32_t, uint32_t, const T& = T()); PointCloud& operator=(const PointCloud&); PointCloud& operator+=(const PointCloud&);
    PointCloud operator+(const PointCloud&) const;
  iterator begin(); iterator end(); const_iterator begin() const; const_iterator end() const; std::size_t size() const; bool empty() const;
    void clear(); void reserve(std::size_t); void resize(std::size_t); T& operator[](std::size_t); const T& operator[](std::size_t) const;
    T& at(std::size_t); const T& at(std::size_t) const; T& at(int, int); const T& at(int, int) const;
    T& operator()(std::size_t, std::size_t); const T& operator()(std::size_t, std::size_t) const; T& front(); const T& front() const;
    T& back(); const T& back() const; void push_back(const T&); template <class... A> T& emplace_back(A&&...);
    template <class... A> iterator insert(A&&...); iterator erase(iterator); iterator erase(iterator, iterator); void swap(PointCloud&);
    bool isOrganized() const; Ptr makeShared() const; Eigen::MatrixXf getMatrixXfMap() const;
};
// Algorithms: setters and getters by name, arguments unchecked.
template <class T> class PCLBase { public: typedef PointCloud<T> PointCloudT; typedef typename PointCloud<T>::Ptr PointCloudPtr;
  typedef typename PointCloud<T>::ConstPtr PointCloudConstPtr; typedef PointIndices::Ptr PointIndicesPtr; virtual ~PCLBase();
  template <class C> void setInputCloud(const C&); template <class I> void setIndices(const I&); PointCloudConstPtr getInputCloud() const;
  IndicesPtr getIndices() const; protected: PointCloudConstPtr input_; IndicesPtr indices_; bool initCompute(); bool deinitCompute(); };
template <class T> class Filter : public PCLBase<T> { public: typedef boost::shared_ptr<Filter<T>> Ptr;
  typedef boost::shared_ptr<const Filter<T>> ConstPtr; template <class O> void filter(O&&); void setNegative(bool);
  void setKeepOrganized(bool); void setUserFilterValue(float); void setExtractRemovedIndices(bool);
  IndicesConstPtr getRemovedIndices() const; }; template <class T> using FilterIndices = Filter<T>;
#define ROSARCH_FILTER(Name) template <class T> class Name : public Filter<T> { public: template <class... A> Name(const A&...);
ROSARCH_FILTER(VoxelGrid) void setLeafSize(float, float, float); void setLeafSize(const Eigen::Vector4f&); void setDownsampleAllData(bool);
  void setMinimumPointsNumberPerVoxel(unsigned); void setFilterFieldName(const std::string&); void setFilterLimits(double, double);
  void setSaveLeafLayout(bool); Eigen::Vector3f getLeafSize() const; };
ROSARCH_FILTER(ApproximateVoxelGrid) void setLeafSize(float, float, float); void setDownsampleAllData(bool); };
ROSARCH_FILTER(PassThrough) void setFilterFieldName(const std::string&); void setFilterLimits(float, float);
  void setFilterLimitsNegative(bool); };
ROSARCH_FILTER(ExtractIndices) };
ROSARCH_FILTER(StatisticalOutlierRemoval) void setMeanK(int); void setStddevMulThresh(double); };
ROSARCH_FILTER(RadiusOutlierRemoval) void setRadiusSearch(double); void setMinNeighborsInRadius(int); };
ROSARCH_FILTER(CropBox) void setMin(const Eigen::Vector4f&); void setMax(const Eigen::Vector4f&); void setTransform(const Eigen::Affine3f&);
  void setTranslation(const Eigen::Vector3f&); void setRotation(const Eigen::Vector3f&); };
ROSARCH_FILTER(ProjectInliers) void setModelType(int); template <class C> void setModelCoefficients(const C&); };
ROSARCH_FILTER(RandomSample) void setSample(unsigned); }; ROSARCH_FILTER(UniformSampling) void setRadiusSearch(double); };
  ROSARCH_FILTER(ConditionalRemoval) template <class C> void setCondition(const C&); };
  ROSARCH_FILTER(CropHull) template <class C> void setHullCloud(const C&); template <class C> void setHullIndices(const C&);
  void setDim(int); void setCropOutside(bool); }; ROSARCH_FILTER(ShadowPoints) };
#undef ROSARCH_FILTER
namespace ComparisonOps { enum CompareOp { GT, GE, LT, LE, EQ }; }
  template <class T> class ConditionBase { public: typedef boost::shared_ptr<ConditionBase<T>> Ptr;
  template <class C> void addComparison(const C&); };
  template <class T> class ConditionAnd : public ConditionBase<T> { public: typedef boost::shared_ptr<ConditionAnd<T>> Ptr; };
  template <class T> class ConditionOr : public ConditionBase<T> { public: typedef boost::shared_ptr<ConditionOr<T>> Ptr; };
  template <class T> class FieldComparison { public: typedef boost::shared_ptr<FieldComparison<T>> Ptr;
  typedef boost::shared_ptr<const FieldComparison<T>> ConstPtr; FieldComparison(const std::string&, ComparisonOps::CompareOp, double); };
namespace search { template <class T> class Search { public: typedef boost::shared_ptr<Search<T>> Ptr;
  typedef boost::shared_ptr<const Search<T>> ConstPtr; virtual ~Search(); template <class... A> void setInputCloud(const A&...);
  template <class... A> int nearestKSearch(A&&...) const; template <class... A> int radiusSearch(A&&...) const; void setSortedResults(bool);
  }; template <class T> class KdTree : public Search<T> { public: typedef boost::shared_ptr<KdTree<T>> Ptr;
  typedef boost::shared_ptr<const KdTree<T>> ConstPtr; KdTree(bool = true); };
  template <class T> class OrganizedNeighbor : public Search<T> { public: typedef boost::shared_ptr<OrganizedNeighbor<T>> Ptr; };
  template <class T> class Octree : public Search<T> {}; }
template <class T> class KdTree : public search::Search<T> { public: typedef boost::shared_ptr<KdTree<T>> Ptr; void setEpsilon(float);
  template <class R> void setPointRepresentation(const R&); };
  template <class T> class KdTreeFLANN : public KdTree<T> { public: typedef boost::shared_ptr<KdTreeFLANN<T>> Ptr; KdTreeFLANN(bool = true);
  };
namespace octree { template <class T> class OctreePointCloudSearch : public search::Search<T> { public: typedef
  boost::shared_ptr<OctreePointCloudSearch<T>> Ptr; OctreePointCloudSearch(double); void addPointsFromInputCloud();
  template <class... A> bool voxelSearch(A&&...); void deleteTree(); };
  template <class T> class OctreePointCloudChangeDetector : public OctreePointCloudSearch<T> {}; }
enum SacModel { SACMODEL_PLANE, SACMODEL_LINE, SACMODEL_CIRCLE2D, SACMODEL_CIRCLE3D, SACMODEL_SPHERE, SACMODEL_CYLINDER, SACMODEL_CONE,
  SACMODEL_PARALLEL_LINE = 8, SACMODEL_PERPENDICULAR_PLANE = 9, SACMODEL_NORMAL_PLANE = 11, SACMODEL_PARALLEL_PLANE = 15,
  SACMODEL_STICK = 17 }; enum { SAC_RANSAC, SAC_LMEDS, SAC_MSAC, SAC_RRANSAC, SAC_RMSAC, SAC_MLESAC, SAC_PROSAC };
template <class T> class SACSegmentation : public PCLBase<T> { public: SACSegmentation(bool = false); void setModelType(int);
  void setMethodType(int); void setDistanceThreshold(double); void setMaxIterations(int); void setProbability(double);
  void setOptimizeCoefficients(bool); void setRadiusLimits(double, double); template <class A> void setAxis(const A&);
  void setEpsAngle(double); template <class... A> void segment(A&&...); template <class N> void setInputNormals(const N&);
  void setNormalDistanceWeight(double); }; template <class T, class N> class SACSegmentationFromNormals : public SACSegmentation<T> {};
template <class T> class EuclideanClusterExtraction : public PCLBase<T> { public: EuclideanClusterExtraction();
  void setClusterTolerance(double); void setMinClusterSize(int); void setMaxClusterSize(int);
  template <class S> void setSearchMethod(const S&); template <class O> void extract(O&); };
  template <class T> class ConditionalEuclideanClustering : public PCLBase<T> { public: ConditionalEuclideanClustering(bool = false);
  void setClusterTolerance(float); void setMinClusterSize(int); void setMaxClusterSize(int);
  template <class F> void setConditionFunction(const F&); template <class O> void segment(O&);
  template <class A, class B> void getRemovedClusters(A&, B&); template <class S> void setSearchMethod(const S&); };
  typedef std::vector<PointIndices> IndicesClusters; typedef boost::shared_ptr<IndicesClusters> IndicesClustersPtr;
  template <class... A> void extractEuclideanClusters(A&&...);
template <class T, class N = Normal> class RegionGrowing : public PCLBase<T> { public: template <class O> void extract(O&);
  void setMinClusterSize(int); void setMaxClusterSize(int); template <class S> void setSearchMethod(const S&);
  void setNumberOfNeighbours(unsigned); template <class C> void setInputNormals(const C&); void setSmoothnessThreshold(float);
  void setCurvatureThreshold(float); typename PointCloud<PointXYZRGB>::Ptr getColoredCloud(); };
  template <class T> class ProgressiveMorphologicalFilter : public PCLBase<T> { public: void setMaxWindowSize(int); void setSlope(float);
  void setInitialDistance(float); void setMaxDistance(float); template <class O> void extract(O&); };
  template <class T> class ExtractPolygonalPrismData : public PCLBase<T> { public: template <class C> void setInputPlanarHull(const C&);
  void setHeightLimits(double, double); template <class O> void segment(O&); };
template <class T, class O> class Feature : public PCLBase<T> { public: typedef boost::shared_ptr<Feature<T, O>> Ptr;
  template <class S> void setSearchMethod(const S&); template <class S> void setSearchSurface(const S&); void setKSearch(int);
  void setRadiusSearch(double); template <class C> void compute(C&); void setNumberOfThreads(unsigned);
  void setViewPoint(float, float, float); template <class N> void setInputNormals(const N&); void useSensorOriginAsViewPoint(); };
  template <class T, class N, class O> class FeatureFromNormals : public Feature<T, O> {};
template <class T, class N> class NormalEstimation : public Feature<T, N> { public: typedef boost::shared_ptr<NormalEstimation<T, N>> Ptr;
  }; template <class T, class N> class NormalEstimationOMP : public NormalEstimation<T, N> { public: NormalEstimationOMP(unsigned = 0); };
  template <class T, class N> class IntegralImageNormalEstimation : public NormalEstimation<T,
  N> { public: enum NormalEstimationMethod { COVARIANCE_MATRIX, AVERAGE_3D_GRADIENT, AVERAGE_DEPTH_CHANGE };
  void setNormalEstimationMethod(NormalEstimationMethod); void setMaxDepthChangeFactor(float); void setNormalSmoothingSize(float); };
  template <class T, class N, class O> class FPFHEstimation : public FeatureFromNormals<T, N, O> {};
  template <class T, class N, class O> class FPFHEstimationOMP : public FPFHEstimation<T, N, O> {};
  template <class T, class N, class O> class DifferenceOfNormalsEstimation : public Feature<T,
  O> { public: template <class C> void setNormalScaleSmall(const C&); template <class C> void setNormalScaleLarge(const C&);
  template <class C> void computeFeature(C&); };
  template <class T> class PCA : public PCLBase<T> { public: Eigen::Matrix3f& getEigenVectors(); Eigen::Vector3f& getEigenValues();
  Eigen::Vector4f& getMean(); }; template <class T> class MomentOfInertiaEstimation : public PCLBase<T> { public: void compute();
  template <class... A> bool getOBB(A&...) const; template <class... A> bool getAABB(A&...) const; };
template <class S, class T, class Scalar = float> class Registration : public PCLBase<S> {
public:
  typedef Eigen::Matrix4f Matrix4; typedef boost::shared_ptr<Registration> Ptr; template <class C> void setInputSource(const C&);
    template <class C> void setInputTarget(const C&); void setMaximumIterations(int); void setTransformationEpsilon(double);
    void setMaxCorrespondenceDistance(double); void setEuclideanFitnessEpsilon(double); void setRANSACIterations(int);
    void setRANSACOutlierRejectionThreshold(double); template <class... A> void align(A&&...); bool hasConverged() const;
    double getFitnessScore(double = 0); Eigen::Matrix4f getFinalTransformation(); Eigen::Matrix4f getLastIncrementalTransformation();
    int getMaximumIterations(); double getTransformationEpsilon(); double getMaxCorrespondenceDistance();
    double getEuclideanFitnessEpsilon();
protected: typename PointCloud<T>::ConstPtr target_; Eigen::Matrix4f final_transformation_, transformation_, previous_transformation_;
  double transformation_epsilon_, corr_dist_threshold_, inlier_threshold_; int nr_iterations_, max_iterations_; bool converged_;
  std::string reg_name_; typename KdTree<T>::Ptr tree_;
};
#define ROSARCH_REGISTRATION(Name) template <class S, class T> class Name : public Registration<S, \
  T> { public: typedef boost::shared_ptr<Name<S, T>> Ptr; void setResolution(float); void setStepSize(double); float getResolution() const; \
  double getStepSize() const; double getOulierRatio() const; void setOulierRatio(double); double getTransformationProbability() const; \
  int getFinalNumIteration() const; void setUseReciprocalCorrespondences(bool); template <class C> void setCovariances(const C&); \
  void setCorrespondenceRandomness(int); double calculateScore(const PointCloud<S>&) const; };
ROSARCH_REGISTRATION(IterativeClosestPoint) ROSARCH_REGISTRATION(IterativeClosestPointNonLinear)
  ROSARCH_REGISTRATION(GeneralizedIterativeClosestPoint) ROSARCH_REGISTRATION(NormalDistributionsTransform)
  ROSARCH_REGISTRATION(IterativeClosestPointWithNormals)
#undef ROSARCH_REGISTRATION
template <class T> class ConvexHull : public PCLBase<T> { public: template <class... A> void reconstruct(A&&...); void setDimension(int);
  void setComputeAreaVolume(bool); double getTotalArea() const; double getTotalVolume() const; };
  template <class T> class ConcaveHull : public ConvexHull<T> { public: void setAlpha(double); };
  template <class T> class GreedyProjectionTriangulation : public PCLBase<T> { public: template <class... A> void reconstruct(A&&...);
  void setSearchRadius(double); void setMu(double); void setMaximumNearestNeighbors(int); void setMaximumSurfaceAngle(double);
  void setMinimumAngle(double); void setMaximumAngle(double); void setNormalConsistency(bool);
  template <class S> void setSearchMethod(const S&); };
  template <class T, class O> class MovingLeastSquares : public PCLBase<T> { public: template <class C> void process(C&);
  void setComputeNormals(bool); void setPolynomialFit(bool); void setSearchRadius(double);
  template <class S> void setSearchMethod(const S&); };
template <class T> class PointRepresentation { public: virtual ~PointRepresentation(); };
  template <class T> class DefaultPointRepresentation : public PointRepresentation<T> {};
  template <class T> class VoxelGridCovariance : public VoxelGrid<T> {};
  template <class T> class SampleConsensusModelPlane { public: typedef boost::shared_ptr<SampleConsensusModelPlane<T>> Ptr;
  template <class... A> SampleConsensusModelPlane(const A&...); };
  template <class T> class RandomSampleConsensus { public: template <class... A> RandomSampleConsensus(const A&...); bool computeModel();
  void setDistanceThreshold(double); void getInliers(std::vector<int>&); template <class C> void getModelCoefficients(C&); };
class PCDReader { public: template <class... A> int read(A&&...); template <class... A> int readHeader(A&&...); };
  class PCDWriter { public: template <class... A> int write(const A&...); template <class... A> int writeBinary(const A&...);
  template <class... A> int writeASCII(const A&...); template <class... A> int writeBinaryCompressed(const A&...); };
namespace io { template <class... A> int loadPCDFile(A&&...); template <class T, class... A> int loadPCDFile(A&&...);
  template <class... A> int savePCDFile(const A&...); template <class... A> int savePCDFileASCII(const A&...);
  template <class... A> int savePCDFileBinary(const A&...); template <class... A> int savePCDFileBinaryCompressed(const A&...);
  template <class... A> int loadPLYFile(A&&...); template <class... A> int savePLYFile(const A&...);
  template <class... A> int saveVTKFile(const A&...); template <class... A> int loadOBJFile(A&&...);
  template <class... A> int savePCDFileBinaryColor(const A&...); }
#define ROSARCH_PCL(result, name) template <class... A> result name(A&&...);
ROSARCH_PCL(void, fromROSMsg) ROSARCH_PCL(void, toROSMsg) ROSARCH_PCL(void, fromPCLPointCloud2) ROSARCH_PCL(void,
  toPCLPointCloud2) ROSARCH_PCL(void, moveFromROSMsg) ROSARCH_PCL(void, copyPointCloud) ROSARCH_PCL(void,
  transformPointCloud) ROSARCH_PCL(void, transformPointCloudWithNormals) ROSARCH_PCL(unsigned, compute3DCentroid) ROSARCH_PCL(void,
  getMinMax3D) ROSARCH_PCL(void, removeNaNFromPointCloud) ROSARCH_PCL(void, removeNaNNormalsFromPointCloud) ROSARCH_PCL(unsigned,
  computeMeanAndCovarianceMatrix) ROSARCH_PCL(unsigned, computeCovarianceMatrix) ROSARCH_PCL(unsigned,
  computeCovarianceMatrixNormalized) ROSARCH_PCL(void, getTransformation) ROSARCH_PCL(void, getTranslationAndEulerAngles) ROSARCH_PCL(void,
  eigen33) ROSARCH_PCL(void, demeanPointCloud) ROSARCH_PCL(void, concatenateFields) ROSARCH_PCL(bool,
  concatenatePointCloud) ROSARCH_PCL(float, euclideanDistance) ROSARCH_PCL(float, squaredEuclideanDistance) ROSARCH_PCL(double,
  deg2rad) ROSARCH_PCL(double, rad2deg) ROSARCH_PCL(int, getFieldIndex) ROSARCH_PCL(std::string, getFieldsList) ROSARCH_PCL(void,
  flipNormalTowardsViewpoint) ROSARCH_PCL(void, solvePlaneParameters) ROSARCH_PCL(void, calculatePolygonArea) ROSARCH_PCL(double,
  getAngle3D) ROSARCH_PCL(Eigen::Affine3f, getTransformation_) ROSARCH_PCL(void, getPointsInBox) ROSARCH_PCL(void,
  getMaxDistance) ROSARCH_PCL(void, getEulerAngles) ROSARCH_PCL(void, PointCloudXYZRGBtoXYZHSV) ROSARCH_PCL(bool, isXYPointIn2DXYPolygon)
#undef ROSARCH_PCL
class StopWatch { public: double getTime(); double getTimeSeconds(); void reset(); }; class ScopeTime { public: ScopeTime(const char* = "");
  }; double getTime(); class PCLException : public std::exception {};
namespace visualization { enum { PCL_VISUALIZER_POINT_SIZE, PCL_VISUALIZER_OPACITY, PCL_VISUALIZER_LINE_WIDTH, PCL_VISUALIZER_FONT_SIZE,
  PCL_VISUALIZER_COLOR }; template <class T> class PointCloudColorHandlerCustom { public: template <class... A>
  PointCloudColorHandlerCustom(const A&...); };
  template <class T> class PointCloudColorHandlerRGBField { public: template <class... A> PointCloudColorHandlerRGBField(const A&...); };
  template <class T> class PointCloudColorHandlerGenericField { public: template <class... A> PointCloudColorHandlerGenericField(const
  A&...); };
class PCLVisualizer { public: typedef boost::shared_ptr<PCLVisualizer> Ptr; template <class... A> PCLVisualizer(const A&...);
  template <class... A> bool addPointCloud(const A&...); template <class T, class... A> bool addPointCloud(const A&...);
  template <class... A> bool updatePointCloud(const A&...); template <class T, class... A> bool updatePointCloud(const A&...);
  template <class... A> void setBackgroundColor(const A&...); template <class... A> void addCoordinateSystem(const A&...);
  template <class... A> void spinOnce(const A&...); void spin(); bool wasStopped() const;
  template <class... A> bool removePointCloud(const A&...); template <class... A> bool removeAllPointClouds(const A&...);
  template <class... A> bool removeAllShapes(const A&...); template <class... A> bool setPointCloudRenderingProperties(const A&...);
  template <class... A> bool addText(const A&...); template <class... A> bool addCube(const A&...);
  template <class... A> bool addLine(const A&...); template <class... A> bool addSphere(const A&...);
  template <class... A> void setCameraPosition(const A&...); void initCameraParameters(); };
  class CloudViewer { public: CloudViewer(const std::string&); template <class... A> void showCloud(const A&...); bool wasStopped(int = 1);
  }; }
}
