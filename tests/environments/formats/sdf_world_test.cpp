#include "voronaut/environments/formats/sdf_world.h"

#include <gtest/gtest.h>

#include "voronaut/environments/config/config_error.h"
#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

ForeignWorld read(const std::string& text, const ForeignOptions& options) {
  return parse_sdf_world(text, "w.world", options);
}

// As seen from above.
ForeignWorld read(const std::string& text) {
  ForeignOptions all;
  all.cut = BodyCut::columns;
  return read(text, all);
}

std::string sdf_error(const std::string& text) {
  return error_of<ConfigError>([&] { read(text); });
}

// Its models begin in line 4.
std::string sdf(const std::string& models) {
  return "<?xml version=\"1.0\" ?>\n<sdf version='1.6'>\n<world name='default'>\n" + models +
         "</world>\n</sdf>\n";
}

Shapes shapes_of(const std::string& models) { return read(sdf(models)).shapes; }

std::string collision(const std::string& geometry, const std::string& pose = "") {
  return "<collision name='c'>" + pose + "<geometry>" + geometry + "</geometry></collision>";
}

std::string model(const std::string& pose, const std::string& links) {
  return "<model name='m'>" + pose + links + "</model>\n";
}

const std::string kDisc = "<cylinder><radius>0.5</radius><length>1</length></cylinder>";

// As Gazebo writes the worlds of BARN.
const std::string kBarn = R"(<light name='sun' type='directional'>
  <pose frame=''>0 0 10 0 -0 0</pose>
</light>
<model name='ground_plane'>
  <static>1</static>
  <link name='link'>
    <collision name='collision'>
      <geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>
      <surface><friction><ode><mu>100</mu></ode><torsional><ode/></torsional></friction><bounce/></surface>
      <max_contacts>10</max_contacts>
    </collision>
    <visual name='visual'><geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry></visual>
  </link>
</model>
<gravity>0 0 -9.8</gravity>
<atmosphere type='adiabatic'/>
<physics name='default_physics' default='0' type='ode'><max_step_size>0.001</max_step_size></physics>
<scene><ambient>0.4 0.4 0.4 1</ambient><shadows>1</shadows></scene>
<spherical_coordinates><surface_model>EARTH_WGS84</surface_model></spherical_coordinates>
<model name='unit_cylinder_0'>
  <static>1</static>
  <pose frame=''>-2.250000 5.000000 0.000000 0.000000 0.000000 0.000000</pose>
  <link name='link'>
    <inertial><mass>1</mass></inertial>
    <collision name='collision'>
      <geometry><cylinder><radius>0.075000</radius><length>1</length></cylinder></geometry>
      <max_contacts>10</max_contacts>
    </collision>
    <visual name='visual'><geometry><cylinder><radius>9</radius><length>1</length></cylinder></geometry></visual>
    <self_collide>0</self_collide>
  </link>
</model>
<state world_name='default'>
  <model name='unit_cylinder_0'>
    <pose frame=''>-2.25 5 0 0 -0 0</pose>
    <scale>1 1 1</scale>
    <link name='link'><pose frame=''>-2.25 5 0 0 -0 0</pose><velocity>0 0 0 0 -0 0</velocity></link>
  </model>
  <light name='sun'><pose frame=''>0 0 10 0 -0 0</pose></light>
</state>
<gui fullscreen='0'><camera name='user_camera'><pose frame=''>5 -5 2 0 0.275643 2.35619</pose></camera></gui>
)";

TEST(SdfWorld, GivesTheCylindersOfAWorldOfBarn) {
  const ForeignWorld world = read(sdf(kBarn));
  ASSERT_EQ(world.shapes.circles.size(), 1U);
  EXPECT_EQ(world.shapes.circles[0].center, Vec2(-2.25, 5));
  EXPECT_EQ(world.shapes.circles[0].radius_m, 0.075);
  EXPECT_TRUE(world.shapes.polygons.empty());
  EXPECT_FALSE(world.bounds);
}

TEST(SdfWorld, GivesEveryCollisionOfEveryLink) {
  const Shapes shapes = shapes_of(
      model("<pose>1 1 0 0 0 0</pose>",
            "<link name='a'>" + collision("<box><size>4 0.2 1</size></box>") +
                collision("<box><size>0.2 4 1</size></box>") + "</link><link name='b'>" +
                collision(kDisc) + collision("<sphere><radius>2</radius></sphere>") + "</link>"));
  ASSERT_EQ(shapes.polygons.size(), 2U);
  EXPECT_NEAR(bounds_of(shapes.polygons[0]).max.x(), 3, 1e-12);
  EXPECT_NEAR(bounds_of(shapes.polygons[1]).max.y(), 3, 1e-12);
  ASSERT_EQ(shapes.circles.size(), 2U);
  EXPECT_EQ(shapes.circles[0].radius_m, 0.5);
  EXPECT_EQ(shapes.circles[1].radius_m, 2);
}

TEST(SdfWorld, ComposesThePosesOfModelLinkAndCollision) {
  const Shapes shapes =
      shapes_of(model("<pose degrees='true'>1 2 0 0 0 90</pose>",
                      "<link name='l'>" +
                          collision("<box><size>2 0.5 1</size></box>",
                                    "<pose>1 0 0.5 0 0 1.5707963267948966</pose>") +
                          "<pose relative_to='__model__'>3 0 7 1e-17 0 0</pose></link>"));
  ASSERT_EQ(shapes.polygons.size(), 1U);  // at (1, 2) + 4 along y, turned by 180 deg in all
  EXPECT_NEAR((bounds_of(shapes.polygons[0]).min - Vec2(0, 5.75)).norm(), 0, 1e-12);
  EXPECT_NEAR((bounds_of(shapes.polygons[0]).max - Vec2(2, 6.25)).norm(), 0, 1e-12);
}

TEST(SdfWorld, ReadsWhatXmlAllows) {
  const Shapes shapes = shapes_of(
      "<!-- <model> > --><plugin name='a>b' filename=\"it's/\"><![CDATA[ </x> <y> ]]></plugin>\n" +
      model("<pose frame = ''>1 <!-- x --> 2 <![CDATA[0 0]]> 0\n0</pose>",
            "<link name='l'>" + collision(kDisc) + "</link >"));
  ASSERT_EQ(shapes.circles.size(), 1U);
  EXPECT_EQ(shapes.circles[0].center, Vec2(1, 2));
  EXPECT_EQ(read("<!DOCTYPE sdf>\n<sdf><world>" +
                 model("", "<link>" + collision(kDisc) + "</link>") + "</world></sdf>")
                .shapes.circles.size(),
            1U);
}

TEST(SdfWorld, TakesNoOtherElementForACollision) {
  EXPECT_TRUE(shapes_of(model("", "<link><collisions><pose>x</pose></collisions></link>")).empty());
}

TEST(SdfWorld, LeavesOutWhatIsPlainlyNoObstacle) {
  EXPECT_TRUE(
      shapes_of("<include><uri>model://sun</uri></include><include><pose>0 0 0 0 0 0</pose><uri> "
                "https://fuel.gazebosim.org/1.0/OpenRobotics/models/Ground Plane\n</uri></include>"
                "<model name='camera'><pose>0 0 5 0 1 0</pose><link name='l'><visual name='v'>"
                "<geometry><mesh><uri>x.dae</uri></mesh></geometry></visual></link></model>" +
                model("<pose relative_to='f'>1 1 0 0 0 0</pose>",
                      "<link name='l'>" + collision("<empty/>") + "</link>"))
          .empty());
}

TEST(SdfWorld, IsRefusedWhereAnObstacleWouldBeLost) {
  const auto collides = [](const std::string& geometry) {
    return sdf_error(sdf(model("", "<link name='l'>\n" + collision(geometry) + "</link>")));
  };
  const std::string disc = "<link name='l'>" + collision(kDisc) + "</link>";
  EXPECT_EQ(collides("<mesh><uri>x.dae</uri></mesh>"),
            "w.world:5: a collision of <mesh> cannot be read (allowed: cylinder, box, sphere, "
            "plane)");
  EXPECT_EQ(collides("<polyline><point>0 0</point></polyline>").substr(0, 36),
            "w.world:5: a collision of <polyline>");
  EXPECT_EQ(collides("<cylinder/>"), "w.world:5: a <cylinder> without its radius");
  EXPECT_EQ(collides("<box/>"), "w.world:5: a <box> without its size");
  EXPECT_EQ(collides("<plane><normal>1 0 0</normal></plane>"),
            "w.world:5: a plane that is not level cannot be read");
  EXPECT_EQ(sdf_error(sdf("\n<include><uri>model://unit_box</uri></include>")),
            "w.world:5: an included model cannot be read: 'model://unit_box' (allowed: sun, "
            "ground_plane)");
  EXPECT_EQ(sdf_error(sdf("<include/>")),
            "w.world:4: an included model cannot be read: '' (allowed: sun, ground_plane)");
  EXPECT_EQ(sdf_error(sdf("<population name='p'>" + model("", disc) + "</population>")),
            "w.world:4: a <population> cannot be read");
  EXPECT_EQ(sdf_error(sdf(model("", "\n<include><uri>model://sun</uri></include>"))),
            "w.world:5: an included model in a model cannot be read");
  EXPECT_EQ(sdf_error(sdf(model("\n<pose relative_to='f'>1 1 0 0 0 0</pose>", disc))),
            "w.world:4: a pose relative to 'f' cannot be read: there is no such frame");
  EXPECT_EQ(sdf_error(sdf(model("<pose>1 2 3 0.5 0 0</pose>\n", disc))),
            "w.world:5: a tilted obstacle cannot be read");
  EXPECT_EQ(sdf_error("<sdf><world/>\n<world/></sdf>"),
            "w.world:2: a second <world>; expected one");
}

TEST(SdfWorld, PutsTheNamedFrameWhereThePoseSays) {
  const auto trailer = [](const std::string& attributes) {
    return shapes_of(
               "<frame name='yard'><pose>0 1 0 0 0 1.5707963267948966</pose></frame>\n"
               "<model name='m' " +
               attributes +
               "><pose>5 1 0 0 0 0</pose>"
               "<frame name='hitch' attached_to='tail'><pose>0 0.5 0 0 0 0</pose></frame>"
               "<link name='tail'><pose>3 0 0 0 0 0</pose></link>"
               "<link name='front'>" +
               collision("<box><size>1 2 1</size></box>") + "</link></model>\n")
        .polygons.at(0);
  };
  EXPECT_NEAR((bounds_of(trailer("")).min - Vec2(4.5, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((bounds_of(trailer("placement_frame='__model__'")).min - Vec2(4.5, 0)).norm(), 0,
              1e-12);
  EXPECT_NEAR((bounds_of(trailer("canonical_link='tail'")).min - Vec2(4.5, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((bounds_of(trailer("placement_frame='tail'")).min - Vec2(1.5, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((bounds_of(trailer("placement_frame='hitch'")).min - Vec2(1.5, -0.5)).norm(), 0,
              1e-12);
  EXPECT_EQ(
      sdf_error(sdf("<model placement_frame='x'><link>" + collision(kDisc) + "</link></model>")),
      "w.world:4: a pose relative to 'x' cannot be read: there is no such frame");
}

TEST(SdfWorld, ReadsPosesRelativeToNamedFrames) {
  const Shapes shapes = shapes_of(
      "<frame name='dock'><pose>4 1 0 0 0 1.5707963267948966</pose></frame>\n"
      "<model name='crane'><pose relative_to='dock'>2 0 0 0 0 0</pose>"
      "<link name='a'><pose relative_to='b'>1 0 0 0 0 0</pose>" +
      collision(kDisc) +
      "</link>"
      "<link name='b'><pose>0 3 0 0 0 0</pose></link>"
      "<joint name='j' type='fixed'><parent>a</parent><child>b</child></joint>"
      "<model name='hook'><pose relative_to='j'>0 0 0 0 0 0</pose><link name='h'>"
      "<pose>0 1 0 0 0 0</pose>" +
      collision("<sphere><radius>0.25</radius></sphere>",
                "<pose relative_to='h'>2 0 0 0 0 0</pose>") +
      "</link></model></model>\n<model name='far'><pose relative_to='crane::hook::h'>0 0 0 0 0 0"
      "</pose><link name='l'>" +
      collision("<box><size>1 1 1</size></box>") + "</link></model>\n");
  ASSERT_EQ(shapes.circles.size(), 2U);
  EXPECT_NEAR((shapes.circles[0].center - Vec2(1, 4)).norm(), 0, 1e-12);
  EXPECT_NEAR((shapes.circles[1].center - Vec2(0, 5)).norm(), 0, 1e-12);
  EXPECT_NEAR((bounds_of(shapes.polygons.at(0)).min - Vec2(-0.5, 2.5)).norm(), 0, 1e-12);
  const std::string disc = collision(kDisc) + "</link></model>\n";
  EXPECT_EQ(sdf_error(sdf("<model><link name='a'><pose relative_to='b'>0 0 0 0 0 0</pose></link>\n"
                          "<link name='b'><pose relative_to='a'>0 0 0 0 0 0</pose>" +
                          disc)),
            "w.world:5: frames that are relative to each other");
}

TEST(SdfWorld, ReadsAQuaternion) {
  const std::string half_turn = "<pose rotation_format='quat_xyzw'>3 1 0  0 0 2 0</pose>";
  const Shapes shapes =
      shapes_of(model(half_turn, "<link><pose>1 0 0 0 0 0</pose>" + collision(kDisc) + "</link>"));
  EXPECT_NEAR((shapes.circles.at(0).center - Vec2(2, 1)).norm(), 0, 1e-12);
}

const std::string kCrate =
    "<model name='crate'><pose>6 2.5 0.5 0 0 0</pose><link name='body'>" +
    std::string(
        "<pose>0 1 0 0 0 0</pose><collision name='c'><geometry><box><size>1 2 1</size></box>"
        "</geometry></collision></link></model>\n");

TEST(SdfWorld, IsAsItsStateMovedItsModelsAndLinks) {
  const auto box_of = [](const std::string& state) {
    return bounds_of(shapes_of(kCrate + "<state world_name='default'><sim_time>12 0</sim_time>" +
                               state + "</state>\n")
                         .polygons.at(0));
  };
  EXPECT_NEAR((box_of("").min - Vec2(5.5, 2.5)).norm(), 0, 1e-12);
  EXPECT_NEAR(
      (box_of("<model name='other'><pose>0 0 0 0 0 0</pose></model>").min - Vec2(5.5, 2.5)).norm(),
      0, 1e-12);
  const Bounds moved =
      box_of("<model name='crate'><pose>3 -1 0.5 0 0 1.5707963267948966</pose></model>");
  EXPECT_NEAR((moved.min - Vec2(1, -1.5)).norm(), 0, 1e-12);
  EXPECT_NEAR((moved.max - Vec2(3, -0.5)).norm(), 0, 1e-12);
  // A link's pose in a state is one in the world, as Gazebo saves it.
  const Bounds link = box_of(
      "<model name='crate'><pose>3 -1 0.5 0 0 0</pose><link name='body'><pose>1 7 0.5 0 0 "
      "0</pose></link></model>");
  EXPECT_NEAR((link.min - Vec2(0.5, 6)).norm(), 0, 1e-12);
}

TEST(SdfWorld, IsAsItsStateScaledItsModels) {
  const auto scaled = [](const std::string& geometry, const std::string& scale) {
    return sdf(model("", "<link>" + collision(geometry) + "</link>") +
               "<state><model name='m'><scale>" + scale + "</scale></model></state>\n");
  };
  const Bounds box =
      bounds_of(read(scaled("<box><size>1 2 1</size></box>", "3 0.5 1")).shapes.polygons.at(0));
  EXPECT_NEAR((box.max - Vec2(1.5, 0.5)).norm(), 0, 1e-12);
  EXPECT_EQ(read(scaled(kDisc, "3 3 1")).shapes.circles.at(0).radius_m, 1.5);
  EXPECT_EQ(sdf_error(scaled(kDisc, "3 2 1")),
            "w.world:4: a round body that is scaled out of round cannot be read");
  EXPECT_EQ(sdf_error(scaled(kDisc, "0 0 1")),
            "w.world:4: expected a size from 0.001 to 1000, got 0");
}

TEST(SdfWorld, IsAsItsStateInsertedAndDeletedModels) {
  const Shapes shapes = shapes_of(
      kCrate + model("<pose>1 1 0 0 0 0</pose>", "<link>" + collision(kDisc) + "</link>") +
      "<state><insertions>" + "<model name='late'><pose>2 8 0 0 0 0</pose><link>" +
      collision(kDisc) +
      "</link></model></insertions><deletions><name>crate</name></deletions></state>\n");
  EXPECT_TRUE(shapes.polygons.empty());
  ASSERT_EQ(shapes.circles.size(), 2U);
  EXPECT_EQ(shapes.circles[0].center, Vec2(1, 1));
  EXPECT_EQ(shapes.circles[1].center, Vec2(2, 8));
}

TEST(SdfWorld, IsCutAtThePlaneOfFlight) {
  const std::string lintel =
      model("<pose>2 3 2.35 0 0 0</pose>",
            "<link>" + collision("<box><size>2 0.2 0.3</size></box>") + "</link>");
  const std::string post =
      model("<pose>1 0 0.6 0 0 0</pose>",
            "<link>" + collision("<cylinder><radius>0.2</radius><length>1.2</length></cylinder>") +
                "</link>");
  const std::string ball =
      model("<pose>5 0 1.3 0 0 0</pose>",
            "<link>" + collision("<sphere><radius>0.5</radius></sphere>") + "</link>");
  const auto at = [&](double height_m) {
    ForeignOptions options;
    options.height_m = height_m;
    return read(sdf(lintel + post + ball), options);
  };
  EXPECT_TRUE(at(1).shapes.polygons.empty());
  EXPECT_EQ(at(1).bodies_off_plane, 1);
  ASSERT_EQ(at(1).shapes.circles.size(), 2U);
  EXPECT_EQ(at(1).shapes.circles[0].radius_m, 0.2);
  EXPECT_NEAR(at(1).shapes.circles[1].radius_m, 0.4, 1e-12);
  EXPECT_EQ(at(1.2).shapes.circles.size(), 2U);  // a body that ends there touches the plane
  EXPECT_EQ(at(2.3).shapes.polygons.size(), 1U);
  EXPECT_TRUE(at(2.3).shapes.circles.empty());
  EXPECT_EQ(at(3).bodies_off_plane, 3);
}

TEST(SdfWorld, IsRefusedWithTheLineAndTheReason) {
  EXPECT_EQ(sdf_error(""), "w.world:1: no <world> in <sdf>");
  EXPECT_EQ(sdf_error("<model/>"), "w.world:1: no <world> in <sdf>");
  EXPECT_EQ(sdf_error("<sdf>\n<world>\n"),
            "w.world:2: not valid XML: a tag or an element does not end");
  EXPECT_EQ(sdf_error("<sdf>\n<world>\n</sdf>"),
            "w.world:2: not valid XML: an element does not end, or another one ends in its place");
  EXPECT_EQ(sdf_error("<sdf>\n<world"),
            "w.world:2: not valid XML: a tag or an element does not end");
  EXPECT_EQ(sdf_error("<sdf>\n<world name='>"),
            "w.world:2: not valid XML: an attribute without a value in quotes");
  EXPECT_EQ(sdf_error("<sdf>\n<!-- world"),
            "w.world:2: not valid XML: a comment or declaration does not end");
  EXPECT_EQ(sdf_error("<sdf>\n<![CDATA[ world"),
            "w.world:2: not valid XML: a comment or declaration does not end");
  EXPECT_EQ(sdf_error(sdf("<model>\n<pose>1 2 x 0 0 0</pose><link>" + collision(kDisc) +
                          "</link></model>")),
            "w.world:5: pose: expected a number, got 'x'");
  EXPECT_EQ(
      sdf_error(sdf("<model><pose>1 2 3</pose><link>" + collision(kDisc) + "</link></model>")),
      "w.world:4: pose: expected 6 numbers, got 3");
  EXPECT_EQ(sdf_error(sdf("<model><pose relative_to=f>1 2 3 0 0 0</pose></model>")),
            "w.world:4: not valid XML: an attribute without a value in quotes");
  EXPECT_EQ(sdf_error(sdf(model(
                "", "<link>" + collision("<sphere><radius>0</radius></sphere>") + "</link>"))),
            "w.world:4: expected a size from 0.001 to 1000, got 0");
}

}  // namespace
}  // namespace voronaut
