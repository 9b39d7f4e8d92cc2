import org.jetbrains.kotlin.gradle.dsl.KotlinJvmProjectExtension

plugins { application }

// lines and boards in virtual time, shared with javino-java's tests; agents with faults, shared with argo-testkit's
configure<KotlinJvmProjectExtension> {
    sourceSets.named("main") { kotlin.srcDirs("../javino-java/src/virtual/kotlin", "../argo-testkit/src/planted/kotlin") }
}
sourceSets.named("main") { resources.srcDir("../argo-testkit/src/planted/resources") }

dependencies {
    implementation(project(":argo-arch"))
    implementation(project(":argo-testkit")) // the bench of stops runs in its virtual time
    implementation(project(":argo-recording")) // the bench of recordings
    implementation(project(":argo-ros")) // the bench of robots that speak ROS
    implementation(libs.java.websocket) // its bridge
    implementation(libs.jason)
    implementation(libs.jmh.core)
    implementation(libs.lets.plot.kotlin)
    implementation(libs.lets.plot.awt)
    implementation(libs.slf4j.jdk14) // the log of Lets-Plot
    annotationProcessor(libs.jmh.processor)
}

// Java-WebSocket asks for another version than slf4j-jdk14
configurations.all { resolutionStrategy.force("org.slf4j:slf4j-api:${libs.versions.slf4j.get()}") }

application {
    mainClass = "benchmarks.MainKt"
    applicationDefaultJvmArgs = listOf("--enable-native-access=ALL-UNNAMED") // jSerialComm loads a native library
}
