plugins { `java-library` }

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    implementation(libs.serialization.json) // what a bridge is sent and sends
    implementation(libs.java.websocket) // what ROS clients connect to
    runtimeOnly(libs.slf4j.jdk14) // where it logs to
    compileOnly(project(":argo-tools")) // the tool ros-serve; argo.jar has the tools, other projects need them not
    compileOnly(libs.picocli)
    testImplementation(libs.jason)
    testImplementation(project(":argo-tools"))
    testImplementation(project(":argo-testkit")) // tests run agents in its virtual time
    testImplementation(libs.picocli)
}

// Java-WebSocket asks for another version than slf4j-jdk14
configurations.all { resolutionStrategy.force("org.slf4j:slf4j-api:${libs.versions.slf4j.get()}") }
