#include "voronaut/environments/formats/sdf_world.h"

#include <gtest/gtest.h>

#include "voronaut/environments/config/config_error.h"

namespace voronaut {
namespace {

std::string sdf_error(const std::string& text) {
  try {
    parse_sdf_world(text, "w.world");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

// Its models begin in line 4.
std::string sdf(const std::string& models) {
  return "<?xml version=\"1.0\" ?>\n<sdf version='1.6'>\n<world name='default'>\n" + models +
         "</world>\n</sdf>\n";
}

Shapes shapes_of(const std::string& models) { return parse_sdf_world(sdf(models), "w").shapes; }

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
    <pose frame=''>5 5 5 0 0 0</pose>
    <scale>1 1 1</scale>
    <link name='link'><pose frame=''>5 5 5 0 0 0</pose><velocity>0 0 0 0 -0 0</velocity></link>
  </model>
  <light name='sun'><pose frame=''>0 0 10 0 -0 0</pose></light>
</state>
<gui fullscreen='0'><camera name='user_camera'><pose frame=''>5 -5 2 0 0.275643 2.35619</pose></camera></gui>
)";

TEST(SdfWorld, GivesTheCylindersOfAWorldOfBarn) {
  const ForeignWorld world = parse_sdf_world(sdf(kBarn), "w.world");
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
  EXPECT_EQ(
      parse_sdf_world("<!DOCTYPE sdf [<!ELEMENT x (y)>]><sdf><world>" +
                          model("", "<link>" + collision(kDisc) + "</link>") + "</world></sdf>",
                      "w")
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
  EXPECT_EQ(sdf_error(sdf(model("", "\n" + model("", disc)))),
            "w.world:5: a model in a model cannot be read");
  EXPECT_EQ(sdf_error(sdf(model("\n<pose relative_to='f'>1 1 0 0 0 0</pose>", disc))),
            "w.world:5: a pose relative to 'f' cannot be read");
  EXPECT_EQ(sdf_error(sdf(model("<pose>1 2 3 0.5 0 0</pose>\n", disc))),
            "w.world:4: a tilted obstacle cannot be read");
  EXPECT_EQ(sdf_error("<sdf><world/>\n<world/></sdf>"),
            "w.world:2: a second <world>; expected one");
}

TEST(SdfWorld, IsRefusedWithTheLineAndTheReason) {
  EXPECT_EQ(sdf_error(""), "w.world:1: no <world> in <sdf>");
  EXPECT_EQ(sdf_error("<sdf>\n<world>\n"), "w.world:2: the file ends inside <world>");
  EXPECT_EQ(sdf_error("<sdf>\n<world>\n</sdf>"), "w.world:3: </sdf> ends what is not open");
  EXPECT_EQ(sdf_error("<sdf>\n<world"), "w.world:2: a tag does not end");
  EXPECT_EQ(sdf_error("<sdf>\n<world/model>"), "w.world:2: a name with a '/'");
  EXPECT_EQ(sdf_error("<sdf>\n<world name='>"), "w.world:2: a tag does not end");
  EXPECT_EQ(sdf_error("<sdf>\n<!-- world"), "w.world:2: a comment or declaration does not end");
  EXPECT_EQ(sdf_error("<sdf>\n<![CDATA[ world"),
            "w.world:2: a comment or declaration does not end");
  EXPECT_EQ(sdf_error(sdf("<model>\n<pose>1 2 x 0 0 0</pose></model>")),
            "w.world:5: pose: expected a number, got 'x'");
  EXPECT_EQ(sdf_error(sdf("<model><pose>1 2 3</pose></model>")),
            "w.world:4: pose: expected 6 numbers, got 3");
  EXPECT_EQ(sdf_error(sdf("<model><pose relative_to=f>1 2 3 0 0 0</pose></model>")),
            "w.world:4: an attribute's value is not in quotes");
  EXPECT_EQ(sdf_error(sdf(model(
                "", "<link>" + collision("<sphere><radius>0</radius></sphere>") + "</link>"))),
            "w.world:4: expected a size from 0.001 to 1000, got 0");
}

}  // namespace
}  // namespace voronaut
