import org.jetbrains.kotlin.gradle.dsl.KotlinJvmProjectExtension

plugins {
    application
    alias(libs.plugins.kotlin.serialization)
}

// programs that tests start in processes of their own, shared with the samples' tests
configure<KotlinJvmProjectExtension> {
    sourceSets.named("test") { kotlin.srcDir("../samples/src/program/kotlin") }
}

dependencies {
    implementation(project(":samples")) // its robot, its boards, and how a Jason project is run in a program
    implementation(project(":argo-arch"))
    implementation(project(":argo-tools")) // how wrong arguments are refused
    implementation(libs.jason)
    implementation(libs.picocli)
    // its records, its statistics, its figures
    implementation(libs.serialization.json)
    implementation(libs.commons.math)
    implementation(libs.lets.plot.kotlin)
    implementation(libs.lets.plot.awt)
    implementation(libs.batik.transcoder)
    implementation(libs.batik.codec)
    implementation(libs.slf4j.jdk14) // where Lets-Plot logs to
}

// old copies of what Java has itself, which Batik brings
configurations.all { exclude(group = "xml-apis", module = "xml-apis") }

// Java-WebSocket asks for another version than slf4j-jdk14
configurations.all { resolutionStrategy.force("org.slf4j:slf4j-api:${libs.versions.slf4j.get()}") }

application {
    mainClass = "experiment.MainKt"
    applicationDefaultJvmArgs = listOf("--enable-native-access=ALL-UNNAMED") // jSerialComm loads a native library
}

// what reports say that they were made by
tasks.jar { manifest { attributes("Implementation-Version" to "$version, of an unknown commit") } }

// as ./argo runs it: who watches presses Enter, and files lie where Gradle was called
tasks.named<JavaExec>("run") {
    standardInput = System.`in`
    workingDir = rootDir
}

tasks.processResources {
    // the Jason project, so that it runs from the class path wherever the program is started
    from("agent") { into("experiment") }
    from("agent/filters") { into("filters") }
}
